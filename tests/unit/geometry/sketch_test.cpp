#include <gtest/gtest.h>

#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// Of hundreds of packed fibres on their way in and out, which take their time to be parted.
Fabric thick() {
  Fabric fabric = cloths::pliedSatin();
  Yarn& yarn = fabric.yarns[0];
  yarn.count_tex = 60;
  yarn.migration = 0.3;
  fabric.ends_per_cm = fabric.picks_per_cm = 14;
  return fabric;
}

TEST(SketchedYarn, IsTheYarnButForOverlaps) {
  const Fabric fabric = thick();
  const ClothGeometry sketch(fabric, 8, 8, nullptr, true), cloth(fabric, 8, 8);
  ASSERT_TRUE(sketch.isSketched());
  ASSERT_FALSE(cloth.isSketched());
  for (const System system : {System::warp, System::weft}) {
    const YarnGeometry &a = sketch.yarn(system, 0), &b = cloth.yarn(system, 0);
    EXPECT_EQ(a.fibresPerPly, b.fibresPerPly);
    EXPECT_EQ(a.period, b.period);
    EXPECT_NEAR(a.count_tex, b.count_tex, 1e-3 * b.count_tex);
    EXPECT_NEAR(a.fibreRadius_mm, b.fibreRadius_mm, 0.01 * b.fibreRadius_mm);
  }
  EXPECT_NEAR(sketch.halfThickness_mm(), cloth.halfThickness_mm(), 0.05 * cloth.halfThickness_mm());
  for (int pick = 0; pick < 8; ++pick) {
    const double length = cloth.strands(cloth.key(System::warp, pick, 3)).length_mm();
    EXPECT_NEAR(sketch.strands(sketch.key(System::warp, pick, 3)).length_mm(), length, 0.02 * length);
  }
}

TEST(SketchedYarn, IsNotThereWhereTheYarnIsKnownOrSoonMade) {
  const Fabric fabric = thick();
  const ClothGeometry cloth(fabric, 8, 8);
  EXPECT_FALSE(ClothGeometry(fabric, 9, 9, &cloth, true).isSketched());
  EXPECT_FALSE(ClothGeometry(cloths::plain(), 8, 8, nullptr, true).isSketched());
  Fabric random = fabric;
  random.yarns[0].layout = FibreLayout::random;
  EXPECT_FALSE(ClothGeometry(random, 8, 8, nullptr, true).isSketched());
}

TEST(SketchedYarn, LeavesNoTraceInTheCloth) {
  const Fabric fabric = thick();
  const ClothGeometry sketch(fabric, 8, 8, nullptr, true), after(fabric, 8, 8, &sketch), fresh(fabric, 8, 8);
  EXPECT_FALSE(after.isSketched());
  EXPECT_TRUE(after.differsInWeaveOnly(fresh));
  const auto length = [](const ClothGeometry& geometry) {
    return geometry.strands(geometry.key(System::weft, 2, 3)).length_mm();
  };
  EXPECT_EQ(length(after), length(fresh));
}

}  // namespace
}  // namespace loomlight
