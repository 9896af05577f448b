#include "core/geometry/yarn/crowding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "core/base/random.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "tests/unit/geometry/cloths.h"

namespace loomlight {
namespace {

/// Any weave, whose threads crowd.
Fabric anyWeave(int ends, int picks) {
  Random random(7);
  Fabric fabric = cloths::plain();
  fabric.crowding = 1;
  fabric.weave = fabric.weave.resized(ends, picks);
  for (int pick = 0; pick < picks; ++pick)
    for (int end = 0; end < ends; ++end) fabric.weave = fabric.weave.with(pick, end, random.below(2) != 0);
  return fabric;
}

YarnCellKey keyOf(const ClothGeometry& cloth, System system, int across, int along) {
  return system == System::warp ? cloth.key(system, along, across) : cloth.key(system, across, along);
}

TEST(CellShape, KnowsOfCrowdedThreadsWhatTheCrossingsOfTheYarnsBesideSay) {
  const Fabric fabric = anyWeave(9, 7);
  const ClothGeometry cloth(fabric, 9, 7);
  for (const System system : {System::warp, System::weft}) {
    const auto isOver = [&](int across, int along) {
      return system == System::warp ? fabric.weave.warpOver(along, across) : fabric.weave.warpOver(across, along);
    };
    /// To the yarn after it where only the one before it is on the other side, and the other way round.
    const auto drawnTo = [&](int across, int along) {
      const bool own = isOver(across, along);
      return (isOver(across - 1, along) != own) - (isOver(across + 1, along) != own);
    };
    /// How the thread that is crossed floats: on how many of the yarns beside it lies as it does here.
    const auto otherState = [&](int across, int along) {
      const bool own = isOver(across, along);
      return (isOver(across - 1, along) == own) + (isOver(across + 1, along) == own);
    };
    for (int across = -2; across < 12; ++across) {
      std::vector<ShapeCode> codes(30);
      cloth.codes().read(system, across, -4, codes);
      for (int i = 0; i < 30; ++i) {
        const CellShape shape = shapeOf(codes[static_cast<size_t>(i)]);
        const CellShape::Node* const nodes[] = {&shape.previous, &shape.here, &shape.next};
        for (int node = 0; node < 3; ++node) {
          const int along = i - 4 + node - 1;
          EXPECT_EQ(nodes[node]->leaning,
                    kLeaning * drawnTo(across, along) + drawnTo(across, along - 1) + drawnTo(across, along + 1))
              << across << " " << along;
          EXPECT_EQ(nodes[node]->otherState, otherState(across, along)) << across << " " << along;
        }
      }
    }
  }
}

TEST(CellShape, OfThreadsThatDoNotCrowdTakesThoseCrossedToFloatAlike) {
  Fabric fabric = anyWeave(9, 7);
  fabric.crowding = 0;
  const ClothGeometry cloth(fabric, 9, 7);
  std::vector<ShapeCode> codes(7);
  for (int end = 0; end < 9; ++end) {
    cloth.codes().read(System::warp, end, 0, codes);
    for (const ShapeCode code : codes) {
      EXPECT_EQ(shapeOf(code).here.otherState, shapeOf(code).here.floatState);
      EXPECT_EQ(shapeOf(code).here.leaning, 0);
    }
  }
}

/// Where the middle of a yarn's fibres lies across its cell, along the count of threads.
double middle_mm(const ClothGeometry& cloth, System system, int across, int along) {
  const CellStrands cell = cloth.strands(keyOf(cloth, system, across, along));
  double sum = 0;
  for (const glm::vec3& p : cell.points) sum += p.x;
  const double middle = sum / static_cast<double>(cell.points.size());
  return system == System::warp ? middle : -middle;  // the weft's frame counts against the picks
}

TEST(Crowding, DrawsThreadsTogetherThatFloatSideBySide) {
  Fabric fabric = cloths::hopsack();
  fabric.yarns[0].hairiness_per_mm = 0;
  const ClothGeometry crowded(fabric, 4, 4);
  fabric.crowding = 0;
  const ClothGeometry even(fabric, 4, 4);
  for (const System system : {System::warp, System::weft})
    for (int across = 0; across < 4; ++across) {
      const double aside = middle_mm(crowded, system, across, 1) - middle_mm(even, system, across, 1);
      const double radius = crowded.yarn(system, 0).radius_mm;
      EXPECT_GT(across % 2 == 0 ? aside : -aside, 0.1 * radius) << "to the other of its pair";
    }
}

TEST(Crowding, LeavesPlainWeaveAlone) {
  Fabric fabric = cloths::plain();
  fabric.crowding = 3;
  const ClothGeometry cloth(fabric, 4, 4);
  for (const System system : {System::warp, System::weft})
    for (int across = 0; across < 4; ++across)
      for (int along = 0; along < 4; ++along) EXPECT_EQ(keyOf(cloth, system, across, along).here.aside_mm, 0);
}

TEST(Crowding, GoesNoFurtherThanUntilThreadsTouch) {
  Fabric fabric = cloths::hopsack();
  fabric.crowding = 3;
  for (const double ends_per_cm : {15.0, 33.0, 36.0, 40.0}) {
    SCOPED_TRACE(ends_per_cm);
    fabric.ends_per_cm = ends_per_cm;
    const ClothGeometry cloth(fabric, 4, 4);
    const YarnGeometry& warp = cloth.yarn(System::warp, 0);
    const double aside = std::abs(cloth.key(System::warp, 1, 0).here.aside_mm);
    const double apart = 0.5 * cloth.warpPitch_mm() - aside;  // from the middle of a pair
    EXPECT_GE(apart, 0.9 * warp.halfWidth_mm() - 1e-6) << "rims pressed in by a tenth";
    if (ends_per_cm > 30) {
      EXPECT_NEAR(apart, 0.9 * warp.halfWidth_mm(), 1e-6);
    }
  }
}

TEST(Crowding, OfACrossingThatIsTurnedReachesTheYarnsBesideAndNoFurther) {
  Fabric fabric = anyWeave(40, 40);
  const ClothGeometry before(fabric, 40, 40);
  fabric.weave = fabric.weave.with(20, 20, !fabric.weave.at(20, 20));
  const ClothGeometry after(fabric, 40, 40);
  int beside = 0;
  for (const System system : {System::warp, System::weft})
    for (int across = 0; across < 40; ++across)
      for (int along = 0; along < 40; ++along) {
        if (keyOf(before, system, across, along) == keyOf(after, system, across, along)) continue;
        EXPECT_LE(std::abs(across - 20), 1);
        EXPECT_LE(std::abs(along - 20), kCrossingReach);
        beside += across != 20;
      }
  EXPECT_GT(beside, 0);
}

// To lay fibres takes time, and they lie in the yarn as they did.
TEST(Crowding, KeepsTheFibresOfYarns) {
  Fabric fabric = cloths::hopsack();
  fabric.yarns[0].count_tex = 80;  // many fibres, which would be sketched first
  const ClothGeometry before(fabric, 4, 4);
  fabric.crowding = 2;
  const ClothGeometry after(fabric, 4, 4, &before, true), fresh(fabric, 4, 4);
  ASSERT_TRUE(ClothGeometry(fabric, 4, 4, nullptr, true).isSketched());
  EXPECT_FALSE(after.isSketched());
  EXPECT_EQ(after.yarn(System::warp, 0), fresh.yarn(System::warp, 0));
  EXPECT_FALSE(after.yarn(System::warp, 0) == before.yarn(System::warp, 0));
}

}  // namespace
}  // namespace loomlight
