#include <gtest/gtest.h>

#include "tests/support/fibre_pairs.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

// Fibres that touch lie two radii apart. Yarns that give way to one another hardly run through each other: few pairs
// come closer than one and a half.
TEST(YarnsOfBothSystems, HardlyRunThroughEachOther) {
  Fabric milled = cloths::twill();
  milled.name = "milled";
  milled.milling = 1;
  milled.yarns[0].hairiness_per_mm = 5;
  Fabric threefold = cloths::pliedSatin();
  threefold.name = "three plies";
  for (Yarn& yarn : threefold.yarns) yarn.plies = 3;
  Fabric paired = cloths::plain();
  paired.name = "in pairs";
  paired.ends_per_cm = paired.picks_per_cm = 14;
  paired.warpSpacing = {1, 1.6};
  paired.weftSpacing = {1, 1, 1.5};
  for (const Fabric& fabric :
       {cloths::plain(), cloths::twill(), cloths::pliedSatin(), threefold, cloths::cabled(), milled, paired}) {
    SCOPED_TRACE(fabric.name);
    const ClothGeometry cloth(fabric, 4, 4);
    EXPECT_LT(test::sharePressedTogether(cloth, 1, 2, 1.5), 0.02);
    EXPECT_GT(test::sharePressedTogether(cloth, 1, 2, 2.5), 0) << "they touch";
  }
}

}  // namespace
}  // namespace loomlight
