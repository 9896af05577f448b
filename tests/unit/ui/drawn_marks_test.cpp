/// What tells things apart on the screen: Dear ImGui draws without a window, and its corners are looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "tests/support/windowless_ui.h"
#include "ui/draft/draft_drawing.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/panel_controls.h"

namespace loomlight {
namespace {

class DrawnMarks : public testing::Test {
 protected:
  /// The corners of what is drawn in a panel, in a theme.
  std::vector<ImDrawVert> drawn(const Theme& theme, const std::function<void(Ui&)>& content) {
    std::vector<ImDrawVert> corners;
    ui_.frame(theme, [&](Ui& ui) {
      ImGui::SetNextWindowPos(ImVec2(0, 0));
      ImGui::SetNextWindowSize(ImVec2(264, 600));
      ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground);
      content(ui);
      const ImDrawList& list = *ImGui::GetWindowDrawList();
      corners.assign(list.VtxBuffer.begin(), list.VtxBuffer.end());
      ImGui::End();
    });
    return corners;
  }

 private:
  test::WindowlessUi ui_{ImVec2(1024, 640)};
};

/// As narrow as the smallest window has it, a bar of 36 ends of one yarn is no block: where each end stops is seen.
TEST_F(DrawnMarks, EndsOfAColourBarAreCountedAtThirtySix) {
  constexpr int kEnds = 36;
  Fabric fabric;
  fabric.weave = fabric.weave.resized(kEnds, kEnds);
  const ImVec2 room(162, 110);
  DraftView view;
  fitDraft(view, fabric.weave, ImVec2(room.x, room.x), 1);
  const Theme theme = Theme::light();
  for (const System system : {System::warp, System::weft}) {
    const bool isWarp = system == System::warp;
    const Box cloth{ImVec2(20, 20), isWarp ? ImVec2(20 + room.x, 20 + room.y) : ImVec2(20 + room.y, 20 + room.x)};
    const Box bar = isWarp ? Box{ImVec2(20, 4), ImVec2(cloth.max.x, 18)} : Box{ImVec2(4, 20), ImVec2(18, cloth.max.y)};
    std::set<float> edges;
    for (const ImDrawVert& corner : drawn(theme, [&](Ui& ui) {
           const std::vector<ImVec4> dark(fabric.yarns.size(), theme.text);
           drawBar(ui, fabric, dark, frameOf(view, {}, cloth), system, bar);
         }))
      if (corner.col == packed(theme.text, 0.35f)) edges.insert(isWarp ? corner.pos.x : corner.pos.y);
    EXPECT_GE(edges.size(), 2u * kEnds) << "ends stand in blocks";
  }
}

/// What is chosen is told by a colour of its own: one step of grey is soon overlooked.
TEST_F(DrawnMarks, WhatIsOnIsMarkedInTheAccent) {
  const auto marks = [&](const Theme& theme, const std::function<void(Ui&)>& content) {
    const std::vector<ImDrawVert> corners = drawn(theme, content);
    return std::count_if(corners.begin(), corners.end(),
                         [&](const ImDrawVert& corner) { return corner.col == packed(theme.accent); });
  };
  for (const Theme& theme : {Theme::dark(), Theme::light()}) {
    for (bool on : {false, true}) {
      EXPECT_EQ(marks(theme, [&](Ui& ui) { toggleButton(ui, "toggle", "Floats", "", on); }) > 0, on);
      EXPECT_GT(marks(theme, [&](Ui& ui) { switchField(ui, {"switch", "Singed"}, on); }), 0);
    }
    int none = -1;
    const char* const names[] = {"Z", "S"};
    EXPECT_EQ(marks(theme, [&](Ui& ui) { segmentField(ui, {"way", "Twist"}, names, none); }), 0);
  }
}

}  // namespace
}  // namespace loomlight
