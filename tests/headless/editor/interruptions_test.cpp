/// What comes in between: a question while a picture is rendered, and one while another is up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "app/editor/model/user_folders.h"
#include "tests/headless/editor/headless_editor.h"
#include "tests/headless/editor/small_cloth.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

class Interruptions : public testing::Test {
 protected:
  Interruptions() : file(editor.start(smallCloth("Blue"))) {
    editor.click("tab.cloth");
    edit("9");
  }
  void edit(const std::string& ends_per_cm) {
    editor.edits("an edit", [&] { editor.enter("cloth.ends_per_cm", ends_per_cm); });
  }
  std::string outcome(const std::string& dialog) const { return editor.fact(dialog + ".outcome"); }
  void openTile() { editor.key("ctrl+e"); }
  void openHandover() {
    editor.click("menu.file");
    editor.click("menu.handover");
  }
  /// Once its size is known.
  void setSize(const std::string& dialog) {
    editor.until("its size is known", [&] { return editor.fact(dialog + ".size_mm").ends_with("mm"); });
    editor.click(dialog + ".twist/Off");
    editor.enter(dialog + ".size", "32");
  }
  /// Begins what takes long, and is asked about unsaved work meanwhile, who thinks better of it.
  void expectToGoOn(const std::string& dialog) {
    editor.click(dialog + ".start");
    editor.until("it runs", [&] { return outcome(dialog) == "running"; });
    editor.closeWindow();
    editor.click("message.answer_0");
    editor.until("the dialog is back", [&] { return editor.shows(dialog + ".close"); });
    EXPECT_EQ(outcome(dialog), "running");
    editor.click(dialog + ".close");
    editor.until("it has ended", [&] { return outcome(dialog).starts_with("Cancelled"); });
    editor.click(dialog + ".close");
    editor.untilNoDialogIsOpen();
  }

  HeadlessEditor editor{{1280, 1000, 1}};
  std::string file;
};

TEST_F(Interruptions, ASnapshotGoesOnWhileAQuestionIsAsked) {
  editor.key("ctrl+p");
  editor.enter("snapshot.samples_per_pixel", "1048576");
  expectToGoOn("snapshot");
}

TEST_F(Interruptions, ATileGoesOnWhileAQuestionIsAsked) {
  openTile();
  setSize("tile");
  editor.enter("tile.samples", "65536");
  expectToGoOn("tile");
}

TEST_F(Interruptions, AHandoverGoesOnWhileAQuestionIsAsked) {
  openHandover();
  setSize("handover");
  editor.enter("handover.samples", "65536");
  expectToGoOn("handover");
}

/// It has the processors again, though what has paused it ended behind a question.
TEST_F(Interruptions, TheViewportGoesOnAfterASnapshotThatWasWrittenBehindAQuestion) {
  editor.key("ctrl+p");
  editor.enter("snapshot.width", "16");
  editor.enter("snapshot.samples_per_pixel", "1");
  editor.click("snapshot.start");
  editor.closeWindow();
  editor.until("it is written", [&] { return std::filesystem::exists(editor.homeFile("Blue.png")); });
  EXPECT_TRUE(editor.shows("message.answer_0"));
  editor.click("message.answer_0");
  editor.until("it says so", [&] { return outcome("snapshot").starts_with("Saved"); });
  editor.click("snapshot.close");
  editor.untilNoDialogIsOpen();
  edit("11");
  editor.untilPictured();
  editor.until("the view rests", [&] { return editor.fact("phase") == "converged"; });
}

TEST_F(Interruptions, TheOfferOfUnsavedWorkIsNotLostToWhatElseIsSaid) {
  const auto isLeft = [] {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(stateFolder(), none))
      if (entry.path().extension() == ".json") return true;
    return false;
  };
  editor.until("a copy is kept", isLeft);
  editor.crash();
  editor.settings().colours.displayFile = editor.homeFile("gone.icc");
  editor.settings().colours.printerFile = editor.homeFile("gone too.icc");
  editor.startOn(file);
  for (int i = 0; i < 60; ++i) editor.frame();
  EXPECT_THAT(editor.fact("message"), HasSubstr("Take it up again?"));
  editor.click("message.answer_2");
  for (int i = 0; i < 2; ++i) {
    editor.until("a profile is missed", [&] { return editor.fact("message").find("gone") != std::string::npos; });
    editor.click("message.answer_0");
  }
  editor.untilNoDialogIsOpen();
  EXPECT_EQ(editor.fact("dirty"), "yes") << "the work has been taken up";
}

}  // namespace
}  // namespace loomlight
