/// What the editor is set to: units of the trade and the usual piece, kept from one session to the next.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/editor/model/user_folders.h"
#include "tests/headless/editor/headless_editor.h"
#include "tests/headless/editor/small_cloth.h"

namespace loomlight {
namespace {

using testing::EndsWith;

Fabric shirting() {
  Fabric fabric = smallCloth("Shirting");
  fabric.ends_per_cm = 30;
  fabric.picks_per_cm = 27;
  fabric.yarns[0].name = "Ne 30";
  fabric.yarns[0].count_tex = 19.683;
  return fabric;
}

class PreferencesTest : public testing::Test {
 protected:
  PreferencesTest() : file(editor.start(shirting())) {}

  void openPreferences() {
    editor.click("menu.edit");
    editor.click("menu.preferences");
  }
  void setUnits() {
    openPreferences();
    editor.choose("preferences.count_system", "Ne (cotton count)");
    editor.click("preferences.twist_unit/TM");
    editor.click("preferences.lengths/inch");
    editor.enter("preferences.piece_length", "60");
    editor.enter("preferences.piece_width", "140");
    editor.click("preferences.close");
    editor.untilNoDialogIsOpen();
  }
  void expectUnitsUsed() {
    editor.click("tab.cloth");
    editor.until("counts are cotton counts", [&] { return editor.fact("cloth.warp_count") == "30.0 Ne"; });
    EXPECT_EQ(editor.fact("cloth.per_cm"), "30.0 \u00d7 27.0");
    EXPECT_THAT(editor.fact("cloth.repeat"), EndsWith(" in"));
  }

  HeadlessEditor editor;
  std::string file;
};

TEST_F(PreferencesTest, LastToTheNextSession) {
  setUnits();
  expectUnitsUsed();
  editor.leave();
  const Settings kept = readSettings(settingsFile());
  EXPECT_EQ(kept.units.count, CountSystem::cotton);
  EXPECT_EQ(kept.units.piece.length_m, 60);
  EXPECT_EQ(kept.units.piece.width_cm, 140);
  editor.startOn(file);
  expectUnitsUsed();
}

TEST_F(PreferencesTest, ASettInInches) {
  setUnits();
  editor.click("tab.cloth");
  editor.enter("cloth.ends_per_cm", "76.2");
  EXPECT_EQ(editor.fact("dirty"), "no") << "what was there already is no edit";
  editor.enter("cloth.picks_per_cm", "50.8");
  editor.until("typed inches become centimetres", [&] { return editor.fact("cloth.per_cm") == "30.0 \u00d7 20.0"; });
}

TEST_F(PreferencesTest, ThePictureRestsAtTheSamplesAskedFor) {
  openPreferences();
  editor.enter("preferences.samples", "1");
  editor.until("one is one sample", [&] { return editor.fact("preferences.samples") == "1 sample"; });
  editor.enter("preferences.samples", "2");
  editor.until("two are samples", [&] { return editor.fact("preferences.samples") == "2 samples"; });
  editor.click("preferences.close");
  editor.leave();
  EXPECT_EQ(readSettings(settingsFile()).limits.samples, 2);
  editor.startOn(file);
  editor.untilPictured();
  editor.until("the picture is finished, and shown",
               [&] { return editor.fact("phase") == "converged" && editor.number("shown_samples") >= 2; });
  EXPECT_EQ(editor.fact("shown_samples"), "2");
}

/// An open list, then a number that is being typed, then the dialog.
TEST_F(PreferencesTest, EscapeLeavesOneThing) {
  const std::string choice = "preferences.count_system/Ne (cotton count)";
  openPreferences();
  editor.click("preferences.count_system");
  editor.until("the list is open", [&] { return editor.shows(choice); });
  editor.key("Escape");
  editor.until("the list closes", [&] { return !editor.shows(choice); });
  editor.click("preferences.piece_length");
  editor.type("70");
  editor.key("Escape");
  editor.until("the number is left", [&] { return editor.fact("text_input") == "no"; });
  EXPECT_EQ(editor.fact("dialog"), "open") << "Escape was meant for the list and for the number";
  editor.key("Escape");
  editor.untilNoDialogIsOpen();
}

}  // namespace
}  // namespace loomlight
