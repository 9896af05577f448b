#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// Of the fibres' length in a cell that are of the yarn's body, where the middle lies across it.
double middleAcross_mm(const CellStrands& cell) {
  double sum = 0, length = 0;
  for (const CellStrands::Strand& strand : cell.strands) {
    if (strand.loose) continue;
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
      const double piece = glm::distance(cell.points[i], cell.points[i + 1]);
      sum += piece * 0.5 * (cell.points[i].x + cell.points[i + 1].x);
      length += piece;
    }
  }
  return sum / length;
}

/// Distances of neighbouring threads, in a few lines across the cloth.
std::vector<double> distances_mm(const ClothGeometry& cloth, System system, int threads, int lines) {
  std::unordered_map<YarnCellKey, double, YarnCellKeyHash> known;
  const auto middleOf = [&](int across, int along) {
    const YarnCellKey key =
        system == System::warp ? cloth.key(system, along, across) : cloth.key(system, across, along);
    const auto [entry, isNew] = known.try_emplace(key);
    if (isNew) entry->second = middleAcross_mm(cloth.strands(key));
    return entry->second;
  };
  constexpr int kApart = 997;  // cells, some 500 mm: beyond the decimetre over which a yarn's draws hold
  const double pitch_mm = system == System::warp ? cloth.warpPitch_mm() : cloth.weftPitch_mm();
  std::vector<double> distances;
  for (int line = 0; line < lines; ++line)
    for (int i = 0; i < threads; ++i)
      distances.push_back(pitch_mm + middleOf(i + 1, kApart * line) - middleOf(i, kApart * line));
  return distances;
}

double variation_percent(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / static_cast<double>(values.size());
  return 100 * std::sqrt(squares / static_cast<double>(values.size()) - mean * mean) / mean;
}

/// A monofilament beside spun yarns.
Fabric withMonofilament() {
  Fabric f = cloths::mixed();
  f.yarns[2].fibresPerPly = 1;
  return f;
}

// Of n independent values a standard deviation is known to within 1 / sqrt(2 n). Distances that share a thread have a
// correlation of -1/2, so 3000 count as 3000 / (1 + 2 / 4) = 2000: 1.6 %, four of which are 6.3 %; the rest of the 10 %
// is for sections of fibres that are not quite symmetric.
TEST(Sett, NeighboursDifferInTheirDistanceAsAsked) {
  for (Fabric fabric : {cloths::plain(), cloths::slubby(), cloths::pliedSatin(), withMonofilament()})
    for (const double cv_percent : {3.0, 8.0}) {
      SCOPED_TRACE(testing::Message() << fabric.name << ", " << cv_percent << " %");
      fabric.settCv_percent = cv_percent;
      const ClothGeometry cloth(fabric, 4, 4);
      for (const System system : {System::warp, System::weft})
        EXPECT_NEAR(variation_percent(distances_mm(cloth, system, 250, 12)), cv_percent, 0.1 * cv_percent);
    }
}

/// Every kind of cell that a yarn has: in all phases and stretches.
template <class Visit>
void everyCellOf(const ClothGeometry& cloth, System system, Visit&& visit) {
  YarnCellKey key = cloth.key(system, 0, 0);
  const YarnModel& yarn = cloth.yarns().model(system, key.yarn);
  for (key.stretch = 0; key.stretch < (yarn.spool ? yarn.spool->kinds() : 1); ++key.stretch)
    for (key.phase = 0; key.phase < yarn.geometry.period; ++key.phase) visit(yarn, key);
}

TEST(Sett, TakesNothingFromAYarnsMass) {
  for (const double cv_percent : {0.0, 20.0}) {
    SCOPED_TRACE(cv_percent);
    Fabric fabric = cloths::plain();
    fabric.yarns[0].evennessCv_percent = cv_percent;
    fabric.settCv_percent = 15;
    const ClothGeometry cloth(fabric, 4, 4);
    everyCellOf(cloth, System::warp, [&](const YarnModel& yarn, const YarnCellKey& key) {
      const YarnGeometry& g = yarn.geometry;
      const CellStrands cell = cloth.strands(key);
      const double thicker = std::pow(cell.fibreRadius_mm / g.fibreRadius_mm, 2);
      const double mass_tex = 1e6 * thicker * cell.length_mm() * g.fibreMass_g_mm() / cloth.yarns().axisLength_mm(key);
      EXPECT_NEAR(mass_tex / g.count_tex, yarn.stretch(key.stretch).massOfCell(key.phase, g.period), 0.001);
    });
  }
}

/// However far it is asked to wander: even where nearly all of a yarn is slubs, which lie in the middle.
TEST(Sett, AYarnStaysInItsOwnCellsAndThoseBesideThem) {
  Fabric fabric = cloths::slubby();
  fabric.settCv_percent = 20;
  fabric.yarns[0].slubs_per_m = 50;
  fabric.yarns[0].slubLength_mm = 500;
  const ClothGeometry cloth(fabric, 4, 4);
  for (const System system : {System::warp, System::weft})
    everyCellOf(cloth, system, [&](const YarnModel& yarn, const YarnCellKey& key) {
      double farthest_mm = 0;
      for (const glm::vec3& p : cloth.strands(key).points) farthest_mm = std::max<double>(farthest_mm, std::abs(p.x));
      EXPECT_LE(farthest_mm, 1.5 * yarn.geometry.crossPitch_mm) << key.stretch;
      EXPECT_LT(yarn.farthestAside_mm(), 0.5 * yarn.geometry.crossPitch_mm);
    });
}

}  // namespace
}  // namespace loomlight
