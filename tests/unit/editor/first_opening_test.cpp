#include "app/editor/controllers/first_opening.h"

#include <gtest/gtest.h>

#include <future>

#include "tests/support/windowless_ui.h"
#include "ui/widgets/keys.h"

namespace loomlight {
namespace {

/// Dear ImGui without a window, and a file that is not read before it is let go.
class FirstOpeningTest : public testing::Test {
 protected:
  void frame(FirstOpening& opening) {
    ui_.frame(Theme::dark(), [&](Ui& ui) { opening.frame(ui); });
  }

  test::WindowlessUi ui_{ImVec2(1280, 720)};
  std::promise<void> letGo_;
  FileService files_{[] {},
                     [gone = letGo_.get_future().share()](const std::string&, const Fabric&) {
                       gone.wait();
                       WifImport read;
                       read.warnings = {{"It is older than the pressing of yarns.", "", {}}};
                       return read;
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

TEST_F(FirstOpeningTest, WhatIsRemarkedInTheFileIsHandedOn) {
  letGo_.set_value();
  FirstOpening opening(files_, "old.json", Document(Fabric{}), Settings{});
  while (!opening.isOver()) frame(opening);
  ASSERT_EQ(opening.warnings().size(), 1u);
  EXPECT_EQ(opening.warnings()[0].sentence, "It is older than the pressing of yarns.");
}

}  // namespace
}  // namespace loomlight
