/// A weaver at the draft: threading, tie-up, treadling and drawdown edited by mouse, each following the others; and
/// the loom that they are woven on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/headless/editor/weaver.h"

namespace loomlight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class DraftParts : public testing::Test {
 protected:
  DraftParts() {
    editor.start(smallTwill());
    weaver.showsDraft("treadles", "4");
  }
  Draft draft() { return editor.saved().draft.value(); }
  /// A part of the draft is edited: from now on the cloth has one of its own. Returns its weave.
  Rows haveDraft() {
    editor.edits("a click", [&] { editor.clickAt(weaver.treadling(1, 4)); });
    return weaver.rows();
  }

  HeadlessEditor editor;
  Weaver weaver{editor};
};

TEST_F(DraftParts, AClickHangsAnEndOnAnotherShaft) {
  const Rows before = rowsOf(smallTwill().weave);
  editor.edits("a click", [&] { editor.clickAt(weaver.threading(0, 3)); });
  EXPECT_THAT(draft().threading, ElementsAre(ElementsAre(3), ElementsAre(2), ElementsAre(3), ElementsAre(4)));
  const Rows after = weaver.rows();
  for (size_t row = 0; row < 4; ++row) EXPECT_EQ(after[row][0], before[row][2]) << "it does not weave as the third";
}

TEST_F(DraftParts, ADragThreadsSeveralEnds) {
  editor.edits("a drag", [&] { editor.drag(weaver.threading(0, 4), weaver.threading(3, 1)); });
  EXPECT_THAT(draft().threading, ElementsAre(ElementsAre(4), ElementsAre(3), ElementsAre(2), ElementsAre(1)));
}

TEST_F(DraftParts, AClickTiesAndARightDragUnties) {
  editor.edits("a click", [&] { editor.clickAt(weaver.tieUp(0, 3)); });
  EXPECT_THAT(draft().tieUp[0], ElementsAre(1, 3, 4));
  editor.edits("a right drag", [&] { editor.drag(weaver.tieUp(0, 1), weaver.tieUp(0, 4), 1); });
  EXPECT_THAT(draft().tieUp[0], IsEmpty());
  EXPECT_EQ(weaver.rows()[3], "....") << "a treadle that is tied to nothing lifts something";
}

TEST_F(DraftParts, AClickPressesAnotherTreadle) {
  editor.edits("a click", [&] { editor.clickAt(weaver.treadling(1, 4)); });
  EXPECT_THAT(draft().treadling, ElementsAre(ElementsAre(1), ElementsAre(4), ElementsAre(3), ElementsAre(4)));
  EXPECT_EQ(weaver.rows()[2], weaver.rows()[0]) << "the second pick does not weave as the fourth";
}

TEST_F(DraftParts, PaintingTheDrawdownFindsADraftThatKeepsNumbers) {
  haveDraft();
  editor.edits("a click", [&] { editor.clickAt(weaver.crossing(0, 1)); });
  const Draft found = draft();
  EXPECT_THAT(found.threading[0], ElementsAre(1));
  EXPECT_THAT(found.threading[2], ElementsAre(3));
  EXPECT_THAT(found.threading[3], ElementsAre(4));
  weaver.showsDraft("treadles");
}

TEST_F(DraftParts, ALiftplanAndBack) {
  const Rows before = haveDraft();
  editor.click("draft.tab_loom");
  editor.edits("a liftplan replaces tie-up and treadling", [&] { editor.choose("loom.kind", "Liftplan"); });
  EXPECT_EQ(weaver.rows(), before);
  EXPECT_EQ(draft().liftplan.size(), 4u);
  editor.edits("a click lifts a shaft", [&] { editor.clickAt(weaver.treadling(0, 3)); });
  EXPECT_NE(weaver.rows(), before);
  editor.edits("treadles come back", [&] { editor.choose("loom.kind", "Treadles"); });
  weaver.showsDraft("treadles");
}

TEST_F(DraftParts, ALoomOfThreeShaftsWeavesNoTwillAndThatIsSaid) {
  editor.click("draft.tab_structures");
  editor.edits("a structure replaces the weave", [&] { editor.click("structure/Plain"); });
  weaver.showsDraft("treadles", "2");
  editor.click("draft.tab_loom");
  for (int turns = 0; turns < 5; ++turns) editor.wheelAt(editor.centre("loom.shafts"), -1);
  editor.enter("loom.most_shafts", "3");
  editor.click("draft.tab_structures");
  editor.edits("another structure", [&] { editor.click("structure/Twill 2/2"); });
  weaver.showsDraft("jacquard");
  EXPECT_THAT(editor.fact("draft.remark"), HasSubstr("more than 3 shafts"));
  weaver.undo();
  weaver.showsDraft("treadles", "2");
}

TEST_F(DraftParts, TheShedSinksAndTheClothStays) {
  const Rows before = haveDraft();
  editor.click("draft.tab_loom");
  editor.edits("the shed sinks", [&] { editor.click("loom.shed/Sinking"); });
  EXPECT_FALSE(draft().risingShed);
  EXPECT_EQ(weaver.rows(), before);
}

/// Turns the wheel over a row of the page until another row is in sight.
void scrollTo(HeadlessEditor& editor, const std::string& over, const std::string& wanted) {
  const ImVec2 place = editor.centre(over);
  for (int turns = 0; turns < 12; ++turns) {
    if (editor.shows(wanted) && editor.rect(wanted).y1 < editor.screen().y - 110) return;
    editor.wheelAt(place, -1);
  }
  throw HeadlessEditor::Vain(wanted + " does not come into sight over " + over);
}

/// What there is of a draft is said above what the loom has: where that leaves none, its rows stay, and say so.
TEST_F(DraftParts, ALoomOfFewerShaftsMovesNoRow) {
  editor.click("draft.tab_loom");
  scrollTo(editor, "loom.shafts", "loom.most_shafts");
  const HeadlessEditor::Rect before = editor.rect("loom.most_shafts");
  editor.enter("loom.most_shafts", "3");
  weaver.showsDraft("jacquard");
  editor.until("there are no shafts", [&] { return editor.fact("loom.shafts") == "\u2013"; });
  EXPECT_EQ(editor.rect("loom.most_shafts"), before);
  editor.enter("loom.most_shafts", "8");
  weaver.showsDraft("treadles", "4");
  EXPECT_EQ(editor.rect("loom.most_shafts"), before);
}

TEST_F(DraftParts, ALargerRepeatGoesOnAsTheOldOne) {
  const Rows before = haveDraft();
  editor.click("draft.tab_loom");
  scrollTo(editor, "loom.shafts", "draft.picks");
  editor.edits("a larger repeat", [&] { editor.enter("draft.ends", "12"); });
  EXPECT_EQ(weaver.rows(), eachRow(before, [](const std::string& row) { return row + row + row; }));
}

TEST_F(DraftParts, BackAndCornerTurnTheDrawingNotTheCloth) {
  const Rows before = haveDraft();
  editor.key("shift+f");
  const HeadlessEditor::Rect atLeft = editor.rect("draft.cell_0_0");
  const auto isBack = [&] { return editor.rect("draft.cell_0_0") == atLeft; };
  editor.click("draft.back");
  editor.until("the back begins at the other side", [&] { return editor.rect("draft.cell_0_0").x0 > atLeft.x1; });
  editor.click("draft.back");
  editor.until("the face is back", isBack);
  editor.click("draft.tab_loom");
  scrollTo(editor, "loom.shafts", "draft.corner");
  editor.choose("draft.corner", "Top right");
  editor.until("the first thread is at the top right", [&] {
    const HeadlessEditor::Rect now = editor.rect("draft.cell_0_0");
    return now.x0 > atLeft.x1 && now.y1 < atLeft.y0;
  });
  EXPECT_EQ(weaver.rows(), before);
  editor.choose("draft.corner", "Bottom left");
  editor.until("the first thread is back", isBack);
}

TEST_F(DraftParts, UndoShowsWhereTheEditWas) {
  editor.key("shift+f");
  const HeadlessEditor::Rect whole = editor.rect("draft.cell_0_0");
  editor.wheelAt(weaver.crossing(3, 3), 1);
  editor.until("the wheel zooms", [&] { return editor.rect("draft.cell_0_0") != whole; });
  const HeadlessEditor::Rect zoomed = editor.rect("draft.cell_0_0");
  editor.edits("a crossing is turned over", [&] { editor.clickAt(weaver.crossing(3, 3)); });
  editor.key("shift+f");
  editor.until("Shift+F shows the whole repeat", [&] { return editor.rect("draft.cell_0_0") == whole; });
  weaver.undo();
  editor.until("undo shows where it was", [&] { return editor.rect("draft.cell_0_0") == zoomed; });
}

/// Yarns that look alike hide what an effect of colours does: it is drawn all the same, and said.
TEST(StructuresInColour, SayWhereBothYarnsLookAlike) {
  for (const bool alike : {false, true}) {
    Fabric cloth = smallTwill();
    if (alike) cloth.yarns[1].fibre = cloth.yarns[0].fibre;
    HeadlessEditor editor;
    editor.start(cloth);
    editor.until("colours are known", [&] { return editor.fact("yarn_colours") == "known"; });
    editor.click("menu.weave");
    editor.click("menu.structures");
    editor.click("library/Twill");
    editor.until("a twill has no colours", [&] { return editor.fact("structures.alike") == "no"; });
    editor.click("library/Houndstooth");
    editor.until("it is said where they are alike",
                 [&] { return editor.fact("structures.name").starts_with("Houndstooth"); });
    EXPECT_EQ(editor.fact("structures.alike"), alike ? "yes" : "no");
  }
}

TEST_F(DraftParts, StructuresAreTakenFromTheLibrary) {
  editor.click("menu.weave");
  editor.click("menu.structures");
  editor.click("library/Satin");
  editor.until("satin is chosen", [&] { return editor.fact("structures.name") == "Satin 8, move 3"; });
  editor.enter("structures.Ends", "6");
  editor.until("it is said that there is no such satin",
               [&] { return editor.fact("structures.problem").find("no satin") != std::string::npos; });
  editor.click("library/Twill");
  editor.enter("structures.Over", "3");
  editor.edits("a twill is applied", [&] { editor.click("structures.apply"); });
  editor.click("library/Houndstooth");
  editor.edits("houndstooth is applied", [&] { editor.click("structures.apply"); });
  editor.click("structures.close");
  const Fabric houndstooth = editor.saved();
  EXPECT_THAT(houndstooth.warpSequence, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1));
  EXPECT_EQ(houndstooth.weftSequence, houndstooth.warpSequence);
  EXPECT_THAT(rowsOf(houndstooth.weave), ElementsAre("#..#", "..##", ".##.", "##.."));
  weaver.undo();
  const Rows twill = weaver.rows();
  EXPECT_EQ(std::count(twill[0].begin(), twill[0].end(), '#'), 3) << "the twill 3/2 is gone";
}

TEST_F(DraftParts, KeysOfTheWindow) {
  const std::pair<std::function<void()>, std::string> ways[] = {{[&] { editor.key("F1"); }, "Escape"},
                                                                {[&] { editor.character("?"); }, "Return"}};
  for (const auto& [opens, closes] : ways) {
    opens();
    editor.until("the list of keys is shown", [&] { return editor.shows("keys.close"); });
    editor.key(closes);
    editor.untilNoDialogIsOpen();
  }
  editor.key("p");
  editor.until("P hides the panels", [&] { return !editor.shows("draft.select"); });
  editor.key("p");
  editor.until("P brings them back", [&] { return editor.shows("draft.select"); });
  for (const auto& [key, elevation] : {std::pair("2", 35.0), std::pair("3", 12.0), std::pair("1", 90.0)}) {
    editor.key(key);
    EXPECT_EQ(editor.saved().camera.elevation_deg, elevation) << "key " << key;
  }
}

}  // namespace
}  // namespace loomlight
