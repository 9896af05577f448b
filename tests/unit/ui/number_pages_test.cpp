/// Numbers on a page that is left and comes back: none is open that nobody has gone to since.
#include <gtest/gtest.h>

#include "tests/support/windowless_ui.h"
#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

class NumberPages : public testing::Test {
 protected:
  enum class Page { left, shown };

  /// So many frames with a number that is always there, and another one on a page.
  void frames(int count, Page page) {
    for (int i = 0; i < count; ++i) frame(page, false);
  }
  /// One in which Shift+Tab is pressed, which goes to the last number.
  void tab(Page page) { frame(page, true); }

  /// Two in which the number of the page is clicked: it opens in the one after.
  void click() {
    const WidgetProbe::Rect box = ui_.probe().snapshot().widgets.at("ends");
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2);
    for (const bool down : {true, false}) {
      io.MouseDown[0] = down;
      frames(1, Page::shown);
    }
  }

  bool isOpen_ = false;  ///< a number, for text

 private:
  void frame(Page page, bool goesOn) {
    ui_.frame(Theme::dark(), [&](Ui& ui) {
      walkNumbers(ui);
      if (goesOn) ui.memory.tabOrder.go(-1, std::nullopt);
      ImGui::Begin("panel");
      numberField(ui, {"exposure", "Exposure"}, {}, exposure_);
      if (page == Page::shown) numberField(ui, {"ends", "Ends"}, {}, ends_);
      ImGui::End();
      isOpen_ = ui.memory.typing != 0;
    });
  }

  test::WindowlessUi ui_{ImVec2(640, 480)};
  double exposure_ = 0, ends_ = 0;
};

TEST_F(NumberPages, TabOpensANumberThatIsShown) {
  frames(2, Page::shown);
  tab(Page::shown);
  frames(10, Page::shown);
  EXPECT_TRUE(isOpen_);
}

TEST_F(NumberPages, AClickOpensANumber) {
  frames(2, Page::shown);
  click();
  frames(10, Page::shown);
  EXPECT_TRUE(isOpen_);
}

TEST_F(NumberPages, LeftAsANumberOpensComeBackWithoutIt) {
  frames(2, Page::shown);
  click();
  frames(5, Page::left);
  frames(10, Page::shown);
  EXPECT_FALSE(isOpen_);
}

TEST_F(NumberPages, LeftAsTabIsPressedComeBackWithoutIt) {
  frames(2, Page::shown);
  tab(Page::left);
  frames(5, Page::left);
  frames(10, Page::shown);
  EXPECT_FALSE(isOpen_);
}

}  // namespace
}  // namespace loomlight
