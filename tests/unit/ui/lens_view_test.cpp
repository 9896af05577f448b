#include "ui/viewport/lens_view.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

using Grip = LensView::Grip;
constexpr int kWidth = 640, kHeight = 480;
constexpr float kReach = 5;

LensView placedLens() {
  LensView lens;
  lens.toggle();
  lens.grab(Grip::place, {100, 120});
  lens.drag({300, 260}, kWidth, kHeight);
  lens.letGo(kWidth, kHeight);
  return lens;
}

void pull(LensView& lens, ImVec2 from, ImVec2 to) {
  lens.grab(lens.gripAt(from, kReach), from);
  lens.drag(to, kWidth, kHeight);
  lens.letGo(kWidth, kHeight);
}

TEST(LensView, ADragPlacesIt) {
  LensView lens;
  EXPECT_EQ(lens.gripAt({100, 100}, kReach), Grip::none) << "it is not chosen";
  lens.toggle();
  EXPECT_EQ(lens.gripAt({100, 100}, kReach), Grip::place);
  EXPECT_FALSE(lens.placed);
  lens = placedLens();
  EXPECT_TRUE(lens.placed);
  EXPECT_EQ(lens.rect, (LensRect{100, 120, 200, 140}));
  EXPECT_EQ(lens.grip, Grip::none);
}

TEST(LensView, ADragUpAndToTheLeftPlacesTheSame) {
  LensView lens;
  lens.toggle();
  lens.grab(Grip::place, {300, 260});
  lens.drag({100, 120}, kWidth, kHeight);
  EXPECT_EQ(lens.rect, (LensRect{100, 120, 200, 140}));
}

TEST(LensView, AClickPlacesOneOfUsualSizeWithinTheViewport) {
  LensView lens;
  lens.toggle();
  lens.grab(Grip::place, {630, 10});
  lens.drag({631, 11}, kWidth, kHeight);
  EXPECT_FALSE(lens.placed);
  lens.letGo(kWidth, kHeight);
  ASSERT_TRUE(lens.placed);
  EXPECT_EQ(lens.rect.x + lens.rect.width, kWidth);
  EXPECT_EQ(lens.rect.y, 0);
  EXPECT_GE(lens.rect.width, LensView::kNarrowest);
}

TEST(LensView, ASmallDragMakesTheSmallestLens) {
  LensView lens;
  lens.toggle();
  lens.grab(Grip::place, {635, 475});
  lens.drag({628, 470}, kWidth, kHeight);
  EXPECT_EQ(lens.rect.width, LensView::kNarrowest);
  EXPECT_EQ(lens.rect.height, LensView::kLowest);
  EXPECT_EQ(lens.rect.x + lens.rect.width, 635);
}

TEST(LensView, EdgesAndCornersAreGrippedAndNothingElse) {
  const LensView lens = placedLens();  // 100..300 by 120..260
  EXPECT_EQ(lens.gripAt({97, 190}, kReach), Grip::left);
  EXPECT_EQ(lens.gripAt({303, 190}, kReach), Grip::right);
  EXPECT_EQ(lens.gripAt({200, 118}, kReach), Grip::top);
  EXPECT_EQ(lens.gripAt({200, 262}, kReach), Grip::bottom);
  EXPECT_EQ(lens.gripAt({101, 121}, kReach), Grip::topLeft);
  EXPECT_EQ(lens.gripAt({299, 121}, kReach), Grip::topRight);
  EXPECT_EQ(lens.gripAt({101, 259}, kReach), Grip::bottomLeft);
  EXPECT_EQ(lens.gripAt({299, 259}, kReach), Grip::bottomRight);
  EXPECT_EQ(lens.gripAt({200, 190}, kReach), Grip::none) << "the camera is moved through the lens";
  EXPECT_EQ(lens.gripAt({90, 190}, kReach), Grip::none);
  EXPECT_EQ(lens.gripAt({90, 120}, kReach), Grip::none) << "on the line of an edge, but beside it";
}

TEST(LensView, PullingAnEdgeMovesThatEdgeAlone) {
  LensView lens = placedLens();
  pull(lens, {100, 190}, {140, 10});
  EXPECT_EQ(lens.rect, (LensRect{140, 120, 160, 140}));
  pull(lens, {300, 260}, {700, 300});
  EXPECT_EQ(lens.rect, (LensRect{140, 120, 500, 180})) << "as far as the viewport reaches";
  pull(lens, {140, 200}, {900, 200});
  EXPECT_EQ(lens.rect, (LensRect{640 - LensView::kNarrowest, 120, LensView::kNarrowest, 180}))
      << "it does not turn over, and does not get too small";
}

TEST(LensView, MovingKeepsItsSizeAndTheViewport) {
  LensView lens = placedLens();
  lens.grab(Grip::move, {110, 110});
  lens.drag({150, 100}, kWidth, kHeight);
  EXPECT_EQ(lens.rect, (LensRect{140, 110, 200, 140}));
  lens.drag({-500, 5000}, kWidth, kHeight);
  EXPECT_EQ(lens.rect, (LensRect{0, kHeight - 140, 200, 140}));
  lens.letGo(kWidth, kHeight);
  lens.keepWithin(320, 100);
  EXPECT_EQ(lens.rect, (LensRect{0, 0, 200, 100}));
}

TEST(LensView, ClosingForgetsThePlaceAndKeepsTheChoice) {
  LensView lens = placedLens();
  lens.showsDifference = true;
  lens.toggle();
  EXPECT_FALSE(lens.on);
  EXPECT_FALSE(lens.placed);
  EXPECT_TRUE(lens.showsDifference);
}

TEST(LensView, TheBarGoesAboveOrInside) {
  const ImVec2 barSize(250, 24);
  ImVec2 bar = besideLens({100, 120, 200, 140}, barSize, 4, kWidth);
  EXPECT_EQ(bar.x, 100);
  EXPECT_EQ(bar.y, 120 - 4 - 24);
  bar = besideLens({500, 10, 140, 140}, barSize, 4, kWidth);
  EXPECT_EQ(bar.x, kWidth - 250);
  EXPECT_EQ(bar.y, 14);
}

}  // namespace
}  // namespace loomlight
