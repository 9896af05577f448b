#include "ui/viewport/snapshot_strip.h"

#include <gtest/gtest.h>

#include "tests/support/windowless_ui.h"

namespace loomlight {
namespace {

class SnapshotStripTest : public testing::Test {
 protected:
  SnapshotStripEdit frame(const std::vector<std::string>& ids) {
    std::vector<SnapshotItem> items;
    for (const std::string& id : ids) items.push_back({id, {}, 1, id});
    SnapshotStripEdit edit;
    ui_.frame(Theme::dark(), [&](Ui& ui) {
      ImGui::SetNextWindowPos(ImVec2(0, 0));
      ImGui::SetNextWindowSize(ImVec2(800, 100));
      ImGui::Begin("strip", nullptr, ImGuiWindowFlags_NoDecoration);
      edit = snapshotStrip(ui, items, view_);
      ImGui::End();
    });
    return edit;
  }
  SnapshotStripEdit click(const std::string& widget, const std::vector<std::string>& ids) {
    for (int i = 0; i < 3; ++i) frame(ids);
    const WidgetProbe::Rect place = ui_.probe().snapshot().widgets.at(widget);
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(0.5f * (place.x0 + place.x1), 0.5f * (place.y0 + place.y1));
    SnapshotStripEdit last;
    for (const bool down : {false, true, false}) {
      io.MouseDown[0] = down;
      for (int i = 0; i < 2; ++i)
        if (SnapshotStripEdit edit = frame(ids); edit.remove) last = std::move(edit);
    }
    return last;
  }

  test::WindowlessUi ui_{ImVec2(800, 200)};
  SnapshotStripView view_;
};

/// When one more is kept, the first may go.
TEST_F(SnapshotStripTest, TheOneThatWasChosenStaysChosenWhereTheOthersMove) {
  click("snapshot.item_1", {"first", "second"});
  EXPECT_EQ(click("snapshot.remove", {"second", "third"}).remove, "second");
  frame({"third"});
  EXPECT_TRUE(view_.chosen.empty());
}

}  // namespace
}  // namespace loomlight
