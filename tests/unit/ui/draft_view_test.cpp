#include "ui/draft/draft_view.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/draft_derivation.h"
#include "core/fabric/weave/jacquard.h"
#include "ui/draft/draft_layout.h"

namespace loomlight {
namespace {

using Origin = DraftPreferences::Origin;
constexpr Origin kOrigins[] = {Origin::bottomLeft, Origin::bottomRight, Origin::topLeft, Origin::topRight};
const Box kBox{ImVec2(10, 20), ImVec2(310, 320)};

DraftPreferences from(Origin origin) {
  DraftPreferences preferences;
  preferences.origin = origin;
  return preferences;
}

TEST(DraftView, TheCrossingUnderThePointerStaysThereWhileZooming) {
  const ImVec2 pointer(200, 110);
  for (const Origin origin : kOrigins) {
    DraftView view;
    fitDraft(view, Weave(), ImVec2(300, 300), 1);
    const CrossingIndex before = frameOf(view, from(origin), kBox).at(pointer);
    for (float clicks : {3.0f, 2.0f, -4.0f}) {
      zoomDraft(view, frameOf(view, from(origin), kBox), pointer, clicks);
      EXPECT_EQ(frameOf(view, from(origin), kBox).at(pointer), before);
    }
  }
}

TEST(DraftView, FitShowsTheWholeRepeat) {
  const Weave weave = Weave().resized(700, 300);
  DraftView view;
  fitDraft(view, weave, ImVec2(280, 240), 1);
  const DraftFrame frame = frameOf(view, {}, {ImVec2(0, 0), ImVec2(280, 240)});
  EXPECT_EQ(frame.at(ImVec2(0.01f, 239.99f)), (CrossingIndex{0, 0}));
  EXPECT_GE(frame.lastEnd(), 699);
  EXPECT_GE(frame.lastPick(), 299);
}

TEST(DraftView, TheFirstThreadIsInItsCornerAndTheBackTurnsTheEndsRound) {
  DraftView view;
  view.cell = 10;
  for (const Origin origin : kOrigins)
    for (const bool back : {false, true}) {
      view.back = back;
      const bool right = (origin == Origin::bottomRight || origin == Origin::topRight) != back;
      const bool top = origin == Origin::topLeft || origin == Origin::topRight;
      const DraftFrame frame = frameOf(view, from(origin), kBox);
      const ImVec2 corner(right ? kBox.max.x - 1 : kBox.min.x + 1, top ? kBox.min.y + 1 : kBox.max.y - 1);
      EXPECT_EQ(frame.at(corner), (CrossingIndex{0, 0}));
      const Box cell = frame.cells(2, 3);
      EXPECT_FLOAT_EQ(cell.width(), 10);
      EXPECT_FLOAT_EQ(cell.height(), 10);
      EXPECT_EQ(frame.at(ImVec2(cell.min.x + 5, cell.min.y + 5)), (CrossingIndex{2, 3}));
    }
}

TEST(DraftView, ASelectionStartsInTheRepeatAndIsNoLarger) {
  const Weave weave = Weave().resized(6, 4);
  EXPECT_EQ(selectionBetween({3, 5}, {1, 2}, weave), (CellRect{1, 2, 3, 4}));
  EXPECT_EQ(selectionBetween({-1, -2}, {0, 0}, weave), (CellRect{3, 4, 2, 3}));
  EXPECT_EQ(selectionBetween({0, 0}, {50, 50}, weave), (CellRect{0, 0, 4, 6}));
}

TEST(DraftView, ASelectionOverTheEdgeOfTheRepeatGoesOnAtTheOtherSide) {
  const Weave weave = satin(8, 3);
  const CellRect selection = selectionBetween({6, 7}, {9, 8}, weave);
  for (int pick = -8; pick < 16; ++pick)
    for (int end = -8; end < 16; ++end) {
      const int p = (pick + 8) % 8, e = (end + 8) % 8;
      EXPECT_EQ(isSelected(selection, {pick, end}, weave), (p >= 6 || p <= 1) && (e == 7 || e == 0))
          << pick << ' ' << end;
    }
}

TEST(DraftView, AWeaveWithoutADraftIsShownWithItsSmallest) {
  Fabric fabric;
  fabric.weave = twill(2, 2);
  DraftView view;
  ASSERT_NE(draftBeside(fabric, {}, view), nullptr);
  EXPECT_EQ(draftBeside(fabric, {}, view)->shafts, 4);
  view.loom = DraftView::Loom::liftplan;
  EXPECT_EQ(draftBeside(fabric, {}, view)->liftplan.size(), 4u);
  view.loom = DraftView::Loom::jacquard;
  EXPECT_EQ(draftBeside(fabric, {}, view), nullptr);
  view.loom = DraftView::Loom::treadles;
  fabric.weave = damaskJacquard(160, 160);
  std::string remark;
  EXPECT_EQ(draftBeside(fabric, {}, view, &remark), nullptr);
  EXPECT_FALSE(remark.empty());
  // A draft of its own is shown, whatever the loom is said to have.
  fabric = withDraft(Fabric{}, smallestDraft(damaskJacquard(160, 160)));
  EXPECT_EQ(draftBeside(fabric, {}, view), &*fabric.draft);
}

TEST(DraftLayout, PartsShareEdgesWithTheClothAndLeaveItMostOfTheRoom) {
  for (const int shafts : {1, 4, 32, 300})
    for (const int columns : {1, 8, 256})
      for (const bool rulers : {false, true}) {
        const DraftLayout layout = layOutDraft(ImVec2(5, 7), ImVec2(300, 320), shafts, columns, rulers, 1);
        EXPECT_GT(layout.lift, 0);
        EXPECT_EQ(layout.threading.min.x, layout.cloth.min.x);
        EXPECT_EQ(layout.threading.max.x, layout.cloth.max.x);
        EXPECT_EQ(layout.treadling.min.y, layout.cloth.min.y);
        EXPECT_EQ(layout.treadling.max.y, layout.cloth.max.y);
        EXPECT_EQ(layout.tieUp.min.y, layout.threading.min.y);
        EXPECT_EQ(layout.tieUp.min.x, layout.treadling.min.x);
        EXPECT_NEAR(layout.threading.height(), layout.lift * static_cast<float>(shafts), 1);
        EXPECT_NEAR(layout.treadling.width(), layout.lift * static_cast<float>(columns), 1);
        EXPECT_GE(layout.cloth.width(), 0.45f * 300);
        EXPECT_GE(layout.cloth.height(), 0.45f * 320);
      }
  EXPECT_EQ(layOutDraft(ImVec2(0, 0), ImVec2(300, 320), 0, 0, false, 1).threading.width(), 0);
}

}  // namespace
}  // namespace loomlight
