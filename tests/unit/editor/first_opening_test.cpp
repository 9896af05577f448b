#include "app/editor/controllers/first_opening.h"
#include "ui/widgets/keys.h"

#include <gtest/gtest.h>

#include <future>

namespace loomlight {
namespace {

/// Dear ImGui without a window, and a file that is not read before it is let go.
class FirstOpeningTest : public testing::Test {
 protected:
  FirstOpeningTest() : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(1280, 720);
    io.IniFilename = nullptr;
    fonts_ = loadFonts(*io.Fonts, 1);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  ~FirstOpeningTest() override { ImGui::DestroyContext(context_); }

  void frame(FirstOpening& opening) {
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    ImGui::NewFrame();
    probe_.beginFrame();
    Ui ui{theme_, fonts_, probe_, memory_, 1, 0};
    opening.frame(ui);
    ImGui::Render();
  }

  ImGuiContext* context_;
  Theme theme_ = Theme::dark();
  Fonts fonts_;
  WidgetProbe probe_{true};
  FieldMemory memory_;
  std::promise<void> letGo_;
  FileService files_{[] {},
                     [gone = letGo_.get_future().share()](const std::string&, const Fabric&) {
                       gone.wait();
                       return WifImport{};
                     }};
};

TEST_F(FirstOpeningTest, CtrlQEndsTheProgramWhileTheFileIsRead) {
  const Settings settings;
  FirstOpening opening(files_, "slow.json", Document(Fabric{}), settings);
  frame(opening);
  holdLetter(ImGui::GetIO(), 'Q', true);
  frame(opening);
  EXPECT_FALSE(opening.isOver()) << "a Q alone ends nothing";
  holdLetter(ImGui::GetIO(), 'Q', false);
  frame(opening);
  holdControl(ImGui::GetIO(), true);
  holdLetter(ImGui::GetIO(), 'Q', true);
  frame(opening);
  EXPECT_TRUE(opening.isOver() && opening.quits());
  letGo_.set_value();
}

}  // namespace
}  // namespace loomlight
