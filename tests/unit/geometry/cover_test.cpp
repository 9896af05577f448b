#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// The mean share of its pitch that a yarn takes over a whole number of repeats and periods, from its outermost fibres.
double shareUnderFibres(const ClothGeometry& cloth, System system, int index) {
  const bool warp = system == System::warp;
  const auto keyAt = [&](int i) { return warp ? cloth.key(system, i, index) : cloth.key(system, index, i); };
  const YarnGeometry& yarn = cloth.yarn(system, keyAt(0).yarn);
  const int cells = (warp ? cloth.repeatPicks() : cloth.repeatEnds()) * yarn.period;
  constexpr int kSections = 5;
  double sum = 0;
  for (int i = 0; i < cells; ++i) {
    const CellStrands cell = cloth.strands(keyAt(i));
    for (int section = 0; section < kSections; ++section) {
      const auto s = static_cast<float>(((section + 0.5) / kSections - 0.5) * yarn.pitch_mm);
      float lowest = 1e9f, highest = -1e9f;
      for (const CellStrands::Strand& strand : cell.strands) {
        if (strand.loose) continue;
        for (uint32_t k = strand.first; k + 1 < strand.first + strand.count; ++k) {
          const glm::vec3 a = cell.points[k], b = cell.points[k + 1];  // (u, s, z)
          if ((a.y < s) == (b.y < s)) continue;
          const float u = glm::mix(a.x, b.x, (s - a.y) / (b.y - a.y));
          lowest = std::min(lowest, u);
          highest = std::max(highest, u);
        }
      }
      sum += std::min(1.0, (highest - lowest + 2 * cell.fibreRadius_mm) / yarn.crossPitch_mm);
    }
  }
  return sum / (cells * kSections);
}

TEST(Cover, IsTheAreaUnderTheFibresOfTheYarns) {
  for (const Fabric& fabric : {cloths::plain(), cloths::twill(), cloths::pliedSatin(), cloths::cabled()}) {
    const ClothGeometry cloth(fabric, 32, 32);
    const double warp = shareUnderFibres(cloth, System::warp, 0), weft = shareUnderFibres(cloth, System::weft, 0);
    EXPECT_NEAR(cloth.measure().cover, warp + weft - warp * weft, 0.03) << fabric.name;
  }
}

/// A plain weave has crossings only at which its yarns bend both ways, and lie wider than at the end of a float.
TEST(Cover, OfPlainClothIsOfTheWidthThatItsYarnsHave) {
  const Fabric fabric = cloths::plain();
  const ClothGeometry cloth(fabric, 4, 4);
  const auto share = [&](System system) {
    const YarnGeometry& yarn = cloth.yarn(system, 0);
    EXPECT_GT(yarn.pressed[0].across, 1.005 * yarn.pressed[1].across);
    // Half of the way between two crossings a quarter of the width is that of the free yarn, an eighth on average.
    const double across = yarn.pressed[0].across + 0.125 * (yarn.free.across - yarn.pressed[0].across);
    return 2 * across * yarn.radius_mm / yarn.crossPitch_mm;
  };
  const double warp = share(System::warp), weft = share(System::weft);
  EXPECT_NEAR(cloth.measure().cover, warp + weft - warp * weft, 1e-5);
}

TEST(Cover, OfMonofilamentsIsThatOfRoundYarns) {
  Fabric fabric = cloths::plain();
  fabric.yarns[0].fibresPerPly = 1;
  fabric.fibres[0].radius_um = 100;
  const double warp = 0.2 / fabric.warpPitch_mm(), weft = 0.2 / fabric.weftPitch_mm();
  EXPECT_NEAR(ClothGeometry(fabric, 4, 4).measure().cover, warp + weft - warp * weft, 1e-5);
}

TEST(Cover, OfJammedClothIsAllThereIs) {
  Fabric fabric = cloths::plain();
  fabric.ends_per_cm = 100;
  EXPECT_NEAR(ClothGeometry(fabric, 4, 4).measure().cover, 1, 1e-9);
}

}  // namespace
}  // namespace loomlight
