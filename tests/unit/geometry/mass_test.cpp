#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// Grams in the fibres of a cell: what the segments hold, nothing else.
double segmentMass_g(const CellStrands& cell, double density_g_cm3) {
  double volume_mm3 = 0;
  for (const CellStrands::Strand& strand : cell.strands)
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i)
      volume_mm3 += glm::distance(glm::dvec3(cell.points[i]), glm::dvec3(cell.points[i + 1])) * kPi *
                    cell.fibreRadius_mm * cell.fibreRadius_mm;
  return volume_mm3 * density_g_cm3 * 1e-3;
}

/// Mass and length of axis of one yarn over a whole number of repeats and periods, so that every phase of every cell
/// counts equally.
struct Weighed {
  double mass_g = 0, axis_mm = 0, largestRadiusChange = 0;
  double count_tex() const { return mass_g / axis_mm * 1e6; }
};
Weighed weigh(const ClothGeometry& cloth, System system, int index) {
  const bool warp = system == System::warp;
  const auto keyAt = [&](int i) { return warp ? cloth.key(system, i, index) : cloth.key(system, index, i); };
  const YarnGeometry& yarn = cloth.yarn(system, keyAt(0).yarn);
  const int cells = (warp ? cloth.repeatPicks() : cloth.repeatEnds()) * yarn.period;
  Weighed sum;
  for (int i = 0; i < cells; ++i) {
    const CellStrands cell = cloth.strands(keyAt(i));
    sum.mass_g += segmentMass_g(cell, yarn.fibreDensity_g_cm3);
    sum.axis_mm += cloth.yarns().axisLength_mm(keyAt(i));
    sum.largestRadiusChange =
        std::max(sum.largestRadiusChange, std::abs(cell.fibreRadius_mm / yarn.fibreRadius_mm - 1));
  }
  return sum;
}

/// But for uneven yarns, which weigh their count over a kilometre (spool_test.cpp).
std::vector<Fabric> evenCloths() {
  std::vector<Fabric> even = cloths::all();
  std::erase_if(even, [](const Fabric& fabric) { return fabric.yarns[0].evennessCv_percent > 0; });
  return even;
}

TEST(YarnMass, SegmentsWeighTheCount) {
  for (const Fabric& fabric : evenCloths()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 16, 16);
    for (const System system : {System::warp, System::weft}) {
      const auto& sequence = system == System::warp ? fabric.warpSequence : fabric.weftSequence;
      for (int i = 0; i < static_cast<int>(sequence.size()); ++i) {
        const Weighed weighed = weigh(cloth, system, i);
        const Yarn& yarn = fabric.yarns[sequence[i]];
        const YarnCellKey key = system == System::warp ? cloth.key(system, 0, i) : cloth.key(system, i, 0);
        const double count = yarn.fibresPerPly ? cloth.yarn(system, key.yarn).count_tex : yarn.count_tex;
        EXPECT_NEAR(weighed.count_tex() / count, 1, 1e-3);
        EXPECT_LT(weighed.largestRadiusChange, 0.02);
      }
    }
  }
}

TEST(YarnMass, CountFollowsFromAGivenNumberOfFibres) {
  // 48 straight fibres: the count is theirs, and each keeps its own radius.
  Fabric fabric = cloths::mixed();
  fabric.warpSequence = fabric.weftSequence = {2};
  const ClothGeometry cloth(fabric, 4, 4);
  const YarnGeometry& yarn = cloth.yarn(System::warp, 2);
  const double r_mm = fabric.fibres[0].radius_um * kMmPerUm;
  EXPECT_EQ(yarn.fibresPerPly, 48);
  EXPECT_DOUBLE_EQ(yarn.fibreRadius_mm, r_mm);
  EXPECT_NEAR(yarn.count_tex, 48 * kPi * r_mm * r_mm * fabric.fibres[0].density_g_cm3 * 1e3, 1e-3 * yarn.count_tex);
}

TEST(YarnMass, FibreRadiusIsTheFibresButForRounding) {
  const Fabric fabric = cloths::plain();
  const ClothGeometry cloth(fabric, 4, 4);
  const YarnGeometry& yarn = cloth.yarn(System::warp, 0);
  // One fibre more or less in N changes the radius by 1 / (2 N).
  EXPECT_NEAR(yarn.fibreRadius_mm / (fabric.fibres[0].radius_um * kMmPerUm), 1, 1.5 / yarn.fibresPerPly);
}

TEST(YarnMass, ThickBundlesStandForTooManyFibres) {
  Fabric fabric = cloths::plain();
  fabric.yarns[0].count_tex = 5000;
  fabric.fibres[0].radius_um = 1;
  fabric.ends_per_cm = fabric.picks_per_cm = 2;
  const ClothGeometry cloth(fabric, 4, 4);
  EXPECT_LE(cloth.yarn(System::warp, 0).fibresPerPly, kMaxFibresPerPly);
  EXPECT_LE(cloth.strands(cloth.key(System::warp, 0, 0)).points.size(), 2u * kMaxPointsPerCell);
  EXPECT_NEAR(weigh(cloth, System::warp, 0).count_tex(), 5000, 5);
}

TEST(ArealMass, SegmentsWeighWhatSettCountAndCrimpSay) {
  for (const Fabric& fabric : evenCloths()) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 4096, 4096);
    const ClothMeasures measures = cloth.measure();
    double mass_g = 0, analytic = 0;
    for (const System system : {System::warp, System::weft}) {
      const bool warp = system == System::warp;
      const int threads = warp ? cloth.repeatEnds() : cloth.repeatPicks();
      double meanCount = 0, crimpedCount = 0;
      for (int i = 0; i < threads; ++i) {
        const Weighed weighed = weigh(cloth, system, i);
        const YarnCellKey key = warp ? cloth.key(system, 0, i) : cloth.key(system, i, 0);
        const YarnGeometry& yarn = cloth.yarn(system, key.yarn);
        const int cells = (warp ? cloth.repeatPicks() : cloth.repeatEnds()) * yarn.period;
        meanCount += yarn.count_tex / threads;
        crimpedCount += yarn.count_tex * weighed.axis_mm / (cells * yarn.pitch_mm) / threads;
        // One thread of that mass in every `threads` cross pitches; to g per m^2.
        mass_g += weighed.mass_g / (cells * yarn.pitch_mm * threads * yarn.crossPitch_mm) * 1e6;
      }
      const double sett = warp ? fabric.ends_per_cm : fabric.picks_per_cm;
      analytic += 0.1 * sett * crimpedCount;
      if (fabric.yarns.size() == 1) {
        const double crimp = warp ? measures.crimpWarp : measures.crimpWeft;
        EXPECT_NEAR(crimpedCount, meanCount * (1 + crimp), 1e-9 * meanCount);
      }
    }
    EXPECT_NEAR(mass_g / analytic, 1, 1e-3);
    EXPECT_NEAR(measures.arealMass_g_m2 / analytic, 1, 1e-9);
  }
}

TEST(YarnDiameter, FollowsFromCountDensityAndPacking) {
  const Fabric fabric = cloths::plain();
  const ClothGeometry cloth(fabric, 4, 4);
  const double expected = 0.03568 * std::sqrt(30.0 / (1.52 * 0.55));  // Peirce
  EXPECT_NEAR(cloth.minYarnDiameter_mm(), expected, 1e-3 * expected);
}

}  // namespace
}  // namespace loomlight
