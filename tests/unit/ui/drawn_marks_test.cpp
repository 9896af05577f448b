/// What tells things apart on the screen: Dear ImGui draws without a window, and its corners are looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/fabric/yarn/long_floats.h"
#include "tests/support/windowless_ui.h"
#include "ui/draft/draft_canvas.h"
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
  Box boxOf(const std::string& widget) const {
    const WidgetProbe::Rect& place = ui_.probe().snapshot().widgets.at(widget);
    return {ImVec2(place.x0, place.y0), ImVec2(place.x1, place.y1)};
  }

 private:
  test::WindowlessUi ui_{ImVec2(1024, 640)};
};

/// Whether one of those floats lies over or under this crossing of the repeat.
bool isIn(const LongFloats& listed, const Weave& weave, int pick, int end) {
  return std::any_of(listed.longest.begin(), listed.longest.end(), [&](const FloatRun& run) {
    const bool isWarp = run.system == System::warp;
    const int count = isWarp ? weave.picks() : weave.ends();
    return run.across == (isWarp ? end : pick) && ((isWarp ? pick : end) - run.first + count) % count < run.cells;
  });
}

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

/// Marks of long floats are those floats that are listed and counted, at every limit; without the tool there is none.
TEST_F(DrawnMarks, FloatsAreMarkedThatAreListed) {
  Fabric fabric;
  fabric.weave = Weave(std::vector<Weave::Row>{{1, 1, 1, 1, 1, 1, 1, 0},
                                               {0, 1, 1, 1, 0, 1, 1, 0},
                                               {1, 0, 1, 0, 1, 0, 1, 0},
                                               {0, 1, 0, 1, 0, 1, 0, 1},
                                               {1, 0, 1, 0, 1, 0, 1, 0},
                                               {0, 1, 0, 1, 0, 1, 0, 1}});
  fabric.ends_per_cm = 10;
  fabric.picks_per_cm = 20;
  const std::vector<ImVec4> colours(fabric.yarns.size(), ImVec4(0.2f, 0.3f, 0.5f, 1));
  const Theme theme = Theme::dark();
  DraftPreferences preferences;
  size_t listedBefore = 100;
  for (const double limit_mm : {1.0, 2.5, 4.0, 7.0}) {
    preferences.longFloat_mm = limit_mm;
    const LongFloats listed = longFloats(fabric, limit_mm);
    EXPECT_LT(listed.longest.size(), listedBefore);
    listedBefore = listed.longest.size();
    for (const bool wanted : {true, false}) {
      DraftView view;
      view.marksFloats = wanted;
      view.cell = 12;
      const std::vector<ImDrawVert> corners = drawn(theme, [&](Ui& ui) {
        draftCanvas(ui, fabric, colours, 0, preferences, view, std::nullopt, ImVec2(250, 250));
      });
      const DraftFrame frame = frameOf(view, preferences, boxOf("draft.canvas"));
      std::vector<Box> marks;
      for (size_t i = 0; i + 3 < corners.size(); ++i)
        if (corners[i].col == packed(theme.warning, 0.75f)) {
          marks.push_back({corners[i].pos, corners[i + 2].pos});
          i += 3;
        }
      for (int pick = 0; pick < fabric.weave.picks(); ++pick)
        for (int end = 0; end < fabric.weave.ends(); ++end) {
          const Box cell = frame.cells(pick, end);
          const ImVec2 middle(0.5f * (cell.min.x + cell.max.x), 0.5f * (cell.min.y + cell.max.y));
          const bool isMarked = std::any_of(marks.begin(), marks.end(), [&](const Box& mark) {
            return mark.min.x < middle.x && middle.x < mark.max.x && mark.min.y < middle.y && middle.y < mark.max.y;
          });
          EXPECT_EQ(isMarked, wanted && isIn(listed, fabric.weave, pick, end))
              << limit_mm << " mm, pick " << pick << ", end " << end;
        }
    }
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
