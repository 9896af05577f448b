#include "render/scene/fibre_extent.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// A wide twill of two kinds of yarn whose twists have periods of their own.
Fabric wideTwill() {
  Fabric fabric = test::whiteCotton();
  fabric.weave = Weave({{1, 1, 0}, {0, 1, 1}, {1, 0, 1}});
  fabric.yarns.resize(2, fabric.yarns[0]);
  fabric.yarns[1].plyTwist_per_m = 433;
  fabric.warpSequence = {0, 1};
  fabric.weftSequence = {0};
  fabric.drape.width_mm = fabric.drape.height_mm = 500;
  fabric.render.resolution = 1;
  return fabric;
}

// All that fibres depend on repeats after the crossings of one repeat: shapes across and along, phases along.
TEST(FibreExtent, ARepeatIsOneOfWeaveYarnsAndTwist) {
  const auto scene = test::sceneOf(wideTwill());
  const ClothGeometry& geometry = scene->cloth->volume->geometry();
  const FibreSize size = planFibres(*scene->cloth, {1e9, FibreExtent::oneRepeat});
  EXPECT_FALSE(size.isWholePiece());
  EXPECT_GE(size.ends, 16);
  EXPECT_GE(size.picks, 16);
  EXPECT_GE(size.copies.x * size.ends, geometry.ends());
  EXPECT_LT((size.copies.x - 1) * size.ends, geometry.ends());
  for (int pick = 0; pick < size.picks; ++pick)
    for (int end = 0; end < size.ends; ++end) {
      ASSERT_EQ(geometry.key(System::warp, pick, end), geometry.key(System::warp, pick + size.picks, end));
      ASSERT_EQ(geometry.key(System::weft, pick, end), geometry.key(System::weft, pick, end + size.ends));
      YarnCellKey beside = geometry.key(System::warp, pick, end + size.ends);
      beside.phase = geometry.place(System::warp, pick, end).phase;
      ASSERT_EQ(geometry.key(System::warp, pick, end), beside);
    }
}

TEST(FibreExtent, GoesByTheMemoryWhereNobodySays) {
  const auto scene = test::sceneOf(wideTwill());
  const FibreSize whole = planFibres(*scene->cloth, {});
  EXPECT_TRUE(whole.isWholePiece());
  EXPECT_EQ(whole.ends, scene->cloth->volume->geometry().ends());
  EXPECT_TRUE(planFibres(*scene->cloth, {whole.bytes}).isWholePiece());
  const FibreSize bricks = planFibres(*scene->cloth, {0.999 * whole.bytes});
  EXPECT_TRUE(bricks.bricks);
  EXPECT_LT(bricks.bytes, 0.1 * whole.bytes);
  EXPECT_TRUE(planFibres(*scene->cloth, {1, FibreExtent::wholePiece}).isWholePiece());
}

// A piece no larger than its repeat is laid whole, and what is bent has no repeat.
TEST(FibreExtent, SmallPiecesAndBentOnesAreWhole) {
  Fabric fabric = wideTwill();
  fabric.drape.width_mm = fabric.drape.height_mm = 5;
  EXPECT_TRUE(planFibres(*test::sceneOf(fabric)->cloth, {1, FibreExtent::oneRepeat}).isWholePiece());
  fabric.drape.kind = DrapeKind::cylinder;
  const auto bent = test::sceneOf(fabric);
  EXPECT_TRUE(planFibres(*bent->cloth, {1}).isWholePiece());
  EXPECT_TRUE(planFibres(*bent->cloth, {1, FibreExtent::bricks}).bricks);
  EXPECT_THROW(planFibres(*bent->cloth, {1, FibreExtent::oneRepeat}), InputError);
}

// However wide the cloth, copies and what is laid grow together, and slowly.
TEST(FibreExtent, OfWideClothSeveralRepeatsAreLaid) {
  Fabric fabric = wideTwill();
  fabric.drape.width_mm = fabric.drape.height_mm = 10000;
  const FibreSize size = planFibres(*test::sceneOf(fabric)->cloth, {1e9, FibreExtent::oneRepeat});
  EXPECT_LT(size.bytes, 1e9);
  EXPECT_LT(static_cast<double>(size.copies.x) * size.copies.y, 1e6);
}

}  // namespace
}  // namespace loomlight
