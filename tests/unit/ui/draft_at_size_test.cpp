#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/fabric/weave/jacquard.h"
#include "tests/support/windowless_ui.h"
#include "ui/draft/draft_panel.h"

namespace loomlight {
namespace {

/// The draft in a panel: what it would have drawn is counted.
class HeadlessDesk {
 public:
  static constexpr int kWidth = 600, kHeight = 1000;  ///< pixels of the panel

  /// A frame of the draft's panel alone, which may edit the fabric; returns how many corners it drew.
  int draw(Fabric& fabric, DraftView& view, ImVec2 mouse = ImVec2(-1, -1), bool pressed = false) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = mouse;
    io.MouseDown[ImGuiMouseButton_Left] = pressed;
    ui_.frame(theme_, [&](Ui& ui) {
      ImGui::SetNextWindowPos(ImVec2(0, 0));
      ImGui::SetNextWindowSize(ImVec2(kWidth, kHeight));
      ImGui::Begin("draft", nullptr, ImGuiWindowFlags_NoDecoration);
      const std::vector<ImVec4> colours(fabric.yarns.size(), ImVec4(0.2f, 0.3f, 0.5f, 1));
      if (auto edited = draftPanel(ui, fabric, colours, 0, nullptr, preferences_, view, std::nullopt))
        fabric = std::move(*edited);
      ImGui::End();
    });
    return ImGui::GetDrawData()->TotalVtxCount;
  }

  ImVec2 centreOfCloth() const {
    const WidgetProbe::Rect& cloth = ui_.probe().snapshot().widgets.at("draft.canvas");
    return ImVec2(0.5f * (cloth.x0 + cloth.x1), 0.5f * (cloth.y0 + cloth.y1));
  }

 private:
  test::WindowlessUi ui_{ImVec2(1920, 1080)};
  Theme theme_ = Theme::dark();
  DraftPreferences preferences_;
};

Fabric large(int side = 4000) {
  Fabric fabric;
  fabric.weave = damaskJacquard(400, 400).resized(side, side);
  return fabric;
}

/// A dobby draft: every pick lifts half of the shafts, in many small groups.
Fabric manyShafts(int shafts, int picks) {
  Draft draft;
  draft.shafts = shafts;
  for (int end = 0; end < shafts; ++end) draft.threading.push_back({end + 1});
  for (int pick = 0; pick < picks; ++pick) {
    std::vector<int> up;
    for (int shaft = 1; shaft <= shafts; ++shaft)
      if ((shaft + pick) % 4 < 2) up.push_back(shaft);
    draft.liftplan.push_back(up);
  }
  return withDraft(Fabric(), std::move(draft));
}

constexpr float kCellSizes_px[] = {0.05f, 0.3f, 0.9f, 2, 5, 12};

/// As many corners as rectangles have that lie side by side over all of the panel: each of one crossing, and two pixels
/// wide and high at least.
int cornersInSight(float cell_px) {
  const float side = std::max(2.0f, cell_px);
  return 4 * static_cast<int>(std::ceil(HeadlessDesk::kWidth / side) + 1) *
         static_cast<int>(std::ceil(HeadlessDesk::kHeight / side) + 1);
}

/// Were threads or shafts drawn that nobody sees, or that nobody can tell apart, there would be hundreds of times as
/// many.
void expectBoundedByThePanel(Fabric fabric) {
  HeadlessDesk desk;
  DraftView view;
  for (const bool inColour : {false, true})
    for (const bool marksFloats : {false, true})
      for (const float cell : kCellSizes_px) {
        view.inColour = inColour;
        view.marksFloats = marksFloats;
        view.cell = cell;
        view.origin = ImVec2(300, 300);
        EXPECT_LT(desk.draw(fabric, view), cornersInSight(cell)) << cell << " px a crossing";
      }
}

TEST(DraftAtSize, AJacquardIsDrawnAsFarAsItIsSeen) {
  expectBoundedByThePanel(large());
}

// Beyond the panel there may be as much again: it costs nothing.
TEST(DraftAtSize, WhatIsOutOfSightIsNotDrawn) {
  HeadlessDesk desk;
  DraftView view;
  Fabric fabric = large(4000), twice = large(8000);
  for (const float cell : {2, 5, 12}) {
    view.cell = cell;
    view.origin = ImVec2(300, 300);
    EXPECT_EQ(desk.draw(twice, view), desk.draw(fabric, view)) << cell << " px a crossing";
  }
}

TEST(DraftAtSize, AThousandShaftsAreDrawnAsFarAsTheyAreSeen) {
  expectBoundedByThePanel(manyShafts(1000, 2000));
}

TEST(DraftAtSize, AClickInAJacquardMakesOneRowAnew) {
  HeadlessDesk desk;
  const Fabric before = large();
  Fabric fabric = before;
  DraftView view;
  view.cell = 8;
  desk.draw(fabric, view);
  const ImVec2 mouse = desk.centreOfCloth();
  desk.draw(fabric, view, mouse);
  const CrossingIndex under = view.hovered.value();
  desk.draw(fabric, view, mouse, true);
  desk.draw(fabric, view, mouse);
  int rowsMade = 0;
  for (int pick = 0; pick < fabric.weave.picks(); ++pick)
    rowsMade += fabric.weave.sharedRow(pick) != before.weave.sharedRow(pick);
  EXPECT_EQ(rowsMade, 1);
  EXPECT_NE(fabric.weave.at(under.pick, under.end), before.weave.at(under.pick, under.end));
}

}  // namespace
}  // namespace loomlight
