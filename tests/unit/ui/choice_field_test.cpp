#include <gtest/gtest.h>

#include <array>

#include "tests/support/windowless_ui.h"
#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

using Names = std::array<const char*, 2>;

/// A list of names that are the designer's own.
class NameList {
 public:
  explicit NameList(Names names) : names_(names) {}

  void frames(int count) {
    for (int i = 0; i < count; ++i)
      ui_.frame(Theme::dark(), [&](Ui& ui) {
        ImGui::SetNextWindowPos(ImVec2(0, 0));
        ImGui::SetNextWindowSize(ImVec2(400, 300));
        ImGui::Begin("page", nullptr, ImGuiWindowFlags_NoDecoration);
        choiceField(ui, {"list", "List"}, names_, chosen_);
        ImGui::End();
      });
  }
  /// Of widgets with the same name, the last.
  void click(const std::string& widget) {
    frames(3);  // what opens is placed late
    const WidgetProbe::Rect place = ui_.probe().snapshot().widgets.at(widget);
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(0.5f * (place.x0 + place.x1), 0.5f * (place.y0 + place.y1));
    for (const bool down : {false, true, false}) {
      io.MouseDown[0] = down;
      frames(2);
    }
  }
  /// Of all that is drawn. A letter has four.
  int corners() {
    frames(3);
    return ImGui::GetDrawData()->TotalVtxCount;
  }
  int chosen() const { return chosen_; }

 private:
  test::WindowlessUi ui_{ImVec2(400, 300)};
  Names names_;
  int chosen_ = 0;
};

TEST(ChoiceField, TheSecondOfTwoEqualNamesCanBeChosen) {
  NameList list({"cotton", "cotton"});
  list.click("list");
  list.click("list/cotton");
  EXPECT_EQ(list.chosen(), 1);
}

TEST(ChoiceField, NamesAreShownWhole) {
  std::array<int, 2> shut{}, open{};
  for (const size_t i : {0, 1}) {
    NameList list({i == 0 ? "cotton_no5" : "cotton_##5", "linen"});
    shut[i] = list.corners();
    list.click("list");
    open[i] = list.corners();
  }
  EXPECT_GT(open[0], shut[0]);
  EXPECT_EQ(shut[1], shut[0]);
  EXPECT_EQ(open[1], open[0]);
}

}  // namespace
}  // namespace loomlight
