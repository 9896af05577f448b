#include "ui/viewport/inset_view.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

using Grip = InsetView::Grip;
constexpr int kWidth = 640, kHeight = 480;
constexpr float kReach = 5;

InsetView placedInset() {
  InsetView inset;
  inset.toggle();
  inset.grab(Grip::place, {100, 120});
  inset.drag({300, 260}, kWidth, kHeight);
  inset.letGo(kWidth, kHeight);
  return inset;
}

void pull(InsetView& inset, ImVec2 from, ImVec2 to) {
  inset.grab(inset.gripAt(from, kReach), from);
  inset.drag(to, kWidth, kHeight);
  inset.letGo(kWidth, kHeight);
}

TEST(InsetView, ADragPlacesIt) {
  InsetView inset;
  EXPECT_EQ(inset.gripAt({100, 100}, kReach), Grip::none) << "it is not chosen";
  inset.toggle();
  EXPECT_EQ(inset.gripAt({100, 100}, kReach), Grip::place);
  EXPECT_FALSE(inset.placed);
  inset = placedInset();
  EXPECT_TRUE(inset.placed);
  EXPECT_EQ(inset.rect, (InsetRect{100, 120, 200, 140}));
  EXPECT_EQ(inset.grip, Grip::none);
}

TEST(InsetView, ADragUpAndToTheLeftPlacesTheSame) {
  InsetView inset;
  inset.toggle();
  inset.grab(Grip::place, {300, 260});
  inset.drag({100, 120}, kWidth, kHeight);
  EXPECT_EQ(inset.rect, (InsetRect{100, 120, 200, 140}));
}

TEST(InsetView, AClickPlacesOneOfUsualSizeWithinTheViewport) {
  InsetView inset;
  inset.toggle();
  inset.grab(Grip::place, {630, 10});
  inset.drag({631, 11}, kWidth, kHeight);
  EXPECT_FALSE(inset.placed);
  inset.letGo(kWidth, kHeight);
  ASSERT_TRUE(inset.placed);
  EXPECT_EQ(inset.rect.x + inset.rect.width, kWidth);
  EXPECT_EQ(inset.rect.y, 0);
  EXPECT_GE(inset.rect.width, InsetView::kNarrowest);
}

TEST(InsetView, ASmallDragMakesTheSmallestInset) {
  InsetView inset;
  inset.toggle();
  inset.grab(Grip::place, {635, 475});
  inset.drag({628, 470}, kWidth, kHeight);
  EXPECT_EQ(inset.rect.width, InsetView::kNarrowest);
  EXPECT_EQ(inset.rect.height, InsetView::kLowest);
  EXPECT_EQ(inset.rect.x + inset.rect.width, 635);
}

TEST(InsetView, EdgesAndCornersAreGrippedAndNothingElse) {
  const InsetView inset = placedInset();  // 100..300 by 120..260
  EXPECT_EQ(inset.gripAt({97, 190}, kReach), Grip::left);
  EXPECT_EQ(inset.gripAt({303, 190}, kReach), Grip::right);
  EXPECT_EQ(inset.gripAt({200, 118}, kReach), Grip::top);
  EXPECT_EQ(inset.gripAt({200, 262}, kReach), Grip::bottom);
  EXPECT_EQ(inset.gripAt({101, 121}, kReach), Grip::topLeft);
  EXPECT_EQ(inset.gripAt({299, 121}, kReach), Grip::topRight);
  EXPECT_EQ(inset.gripAt({101, 259}, kReach), Grip::bottomLeft);
  EXPECT_EQ(inset.gripAt({299, 259}, kReach), Grip::bottomRight);
  EXPECT_EQ(inset.gripAt({200, 190}, kReach), Grip::none) << "the camera is moved through the lens";
  EXPECT_EQ(inset.gripAt({90, 190}, kReach), Grip::none);
  EXPECT_EQ(inset.gripAt({90, 120}, kReach), Grip::none) << "on the line of an edge, but beside it";
}

TEST(InsetView, PullingAnEdgeMovesThatEdgeAlone) {
  InsetView inset = placedInset();
  pull(inset, {100, 190}, {140, 10});
  EXPECT_EQ(inset.rect, (InsetRect{140, 120, 160, 140}));
  pull(inset, {300, 260}, {700, 300});
  EXPECT_EQ(inset.rect, (InsetRect{140, 120, 500, 180})) << "as far as the viewport reaches";
  pull(inset, {140, 200}, {900, 200});
  EXPECT_EQ(inset.rect, (InsetRect{640 - InsetView::kNarrowest, 120, InsetView::kNarrowest, 180}))
      << "it does not turn over, and does not get too small";
}

TEST(InsetView, MovingKeepsItsSizeAndTheViewport) {
  InsetView inset = placedInset();
  inset.grab(Grip::move, {110, 110});
  inset.drag({150, 100}, kWidth, kHeight);
  EXPECT_EQ(inset.rect, (InsetRect{140, 110, 200, 140}));
  inset.drag({-500, 5000}, kWidth, kHeight);
  EXPECT_EQ(inset.rect, (InsetRect{0, kHeight - 140, 200, 140}));
  inset.letGo(kWidth, kHeight);
  inset.keepWithin(320, 100);
  EXPECT_EQ(inset.rect, (InsetRect{0, 0, 200, 100}));
}

TEST(InsetView, ClosingForgetsThePlaceAndKeepsTheChoice) {
  InsetView inset = placedInset();
  inset.showsDifference = true;
  inset.toggle();
  EXPECT_FALSE(inset.on);
  EXPECT_FALSE(inset.placed);
  EXPECT_TRUE(inset.showsDifference);
}

TEST(InsetView, TheBarGoesAboveOrInside) {
  const ImVec2 barSize(250, 24);
  ImVec2 bar = besideInset({100, 120, 200, 140}, barSize, 4, kWidth);
  EXPECT_EQ(bar.x, 100);
  EXPECT_EQ(bar.y, 120 - 4 - 24);
  bar = besideInset({500, 10, 140, 140}, barSize, 4, kWidth);
  EXPECT_EQ(bar.x, kWidth - 250);
  EXPECT_EQ(bar.y, 14);
}

}  // namespace
}  // namespace loomlight
