/// Strokes, selections and what keys and menus do with them, on a satin of eight.
#include <gtest/gtest.h>

#include "tests/headless/editor/weaver.h"

namespace loomlight {
namespace {

class DraftSelection : public testing::Test {
 protected:
  DraftSelection() {
    editor.start(smallTwill());
    editor.click("draft.tab_structures");
    weaver.takes("Satin 8");
    editor.until("the whole repeat is shown", [&] { return editor.shows("draft.cell_0_0"); });
    before = weaver.rows();
    EXPECT_EQ(before.size(), 8u);
  }
  void untilSelected(const std::string& what) {
    editor.until("selected: " + what, [&] { return editor.fact("draft.selection") == what; });
  }
  /// Three ends of two picks: row 6 is the second pick.
  std::string within(const Rows& rows, size_t row) { return rows[row].substr(1, 3); }

  HeadlessEditor editor;
  Weaver weaver{editor};
  Rows before;
};

TEST_F(DraftSelection, ADragSelectsAndEditsOnlyThere) {
  editor.click("draft.select");
  editor.drag(weaver.crossing(1, 1), weaver.crossing(2, 3));
  untilSelected("1 1 2 3");
  EXPECT_EQ(weaver.rows(), before) << "selecting changed the weave";
  editor.key("ctrl+c");
  editor.edits("Delete lays the weft on top", [&] { editor.key("Delete"); });
  const Rows cleared = weaver.rows();
  EXPECT_EQ(within(cleared, 6), "...");
  EXPECT_EQ(within(cleared, 5), "...");
  editor.edits("what was copied is pasted", [&] { editor.key("ctrl+v"); });
  EXPECT_EQ(weaver.rows(), before);
  editor.edits("Ctrl+I inverts", [&] { editor.key("ctrl+i"); });
  EXPECT_EQ(within(weaver.rows(), 6), turnedOver(within(before, 6)));
  weaver.takes("Plain");
  Rows expected = before;
  expected[6].replace(1, 3, "#.#");
  expected[5].replace(1, 3, ".#.");
  EXPECT_EQ(weaver.rows(), expected);
  editor.key("Escape");
  untilSelected("none");
}

TEST_F(DraftSelection, CtrlDDeselects) {
  editor.key("ctrl+a");
  untilSelected("0 0 8 8");
  editor.key("ctrl+d");
  untilSelected("none");
  EXPECT_EQ(weaver.rows(), before);
}

/// Keys are for the list then.
TEST_F(DraftSelection, NothingIsEditedBehindAnOpenList) {
  editor.key("ctrl+a");
  untilSelected("0 0 8 8");
  editor.click("menu.view");
  editor.until("the menu is open", [&] { return editor.shows("menu.flat"); });
  for (const char* const key : {"Down", "Delete", "ctrl+i", "n"}) editor.key(key);
  editor.key("Escape");
  editor.until("the menu is shut", [&] { return !editor.shows("menu.flat"); });
  EXPECT_EQ(weaver.rows(), before);
}

/// A list that was shut with the mouse on one within it, which would hold the keyboard without being seen.
TEST_F(DraftSelection, KeysComeBackWhenAMenuIsShut) {
  editor.click("menu.file");
  editor.click("menu.export");
  editor.until("the list within is open", [&] { return editor.shows("menu.export_wif"); });
  editor.key("Escape");
  editor.until("both are shut", [&] { return !editor.shows("menu.export"); });
  editor.key("ctrl+a");
  untilSelected("0 0 8 8");
}

TEST_F(DraftSelection, TheRightButtonAsks) {
  editor.click("draft.select");
  editor.key("ctrl+a");
  untilSelected("0 0 8 8");
  editor.clickAt(weaver.crossing(2, 2), 1);
  editor.edits("the menu inverts the selection", [&] { editor.click("menu.invert"); });
  EXPECT_EQ(weaver.rows(), eachRow(before, turnedOver));
  weaver.undo();
  editor.key("Escape");
  untilSelected("none");
  editor.clickAt(weaver.crossing(3, 2), 1);
  untilSelected("3 2 1 1");
  editor.edits("that one is inverted", [&] { editor.click("menu.invert"); });
  Rows expected = before;
  expected[4].replace(2, 1, turnedOver(before[4].substr(2, 1)));
  EXPECT_EQ(weaver.rows(), expected);
}

TEST_F(DraftSelection, ShiftKeepsAStrokeToALine) {
  editor.hold("shift");
  editor.edits("a stroke", [&] { editor.drag(weaver.crossing(0, 0), weaver.crossing(2, 6)); });
  editor.let("shift");
  Rows expected = before;
  expected[7].replace(0, 7, std::string(7, before[7][0] == '#' ? '.' : '#'));
  EXPECT_EQ(weaver.rows(), expected);
  weaver.undo();
  EXPECT_EQ(weaver.rows(), before) << "a stroke is one step of undo";
}

TEST_F(DraftSelection, TheRightButtonLaysTheWeftOver) {
  editor.edits("a right drag", [&] { editor.drag(weaver.crossing(3, 0), weaver.crossing(3, 7), 1); });
  Rows expected = before;
  expected[4] = "........";
  EXPECT_EQ(weaver.rows(), expected);
}

TEST_F(DraftSelection, ArrowsShiftAndWhatIsCutComesBack) {
  Rows rows = before;
  editor.key("ctrl+a");
  const auto shifts = [&](const std::string& key, Rows expected) {
    editor.edits(key, [&] { editor.key(key); });
    rows = std::move(expected);
    EXPECT_EQ(weaver.rows(), rows) << key << " does not shift that way";
  };
  shifts("Left", eachRow(rows, [](const std::string& row) { return row.substr(1) + row[0]; }));
  Rows up(rows.begin() + 1, rows.end());
  up.push_back(rows.front());
  shifts("Up", up);
  Rows down = {rows.back()};
  down.insert(down.end(), rows.begin(), rows.end() - 1);
  shifts("Down", down);
  shifts("Right", eachRow(rows, [](const std::string& row) { return row.back() + row.substr(0, 7); }));
  editor.edits("Ctrl+X cuts", [&] { editor.key("ctrl+x"); });
  EXPECT_EQ(weaver.rows(), Rows(8, "........"));
  weaver.undo();
  EXPECT_EQ(weaver.rows(), rows);
}

TEST_F(DraftSelection, TheMenuMirrorsAndTurns) {
  Rows rows = before;
  editor.key("ctrl+a");
  const auto does = [&](const std::string& item, Rows expected) {
    editor.click("menu.weave");
    editor.edits(item, [&] { editor.click("menu." + item); });
    rows = std::move(expected);
    EXPECT_EQ(weaver.rows(), rows) << item;
  };
  does("mirror_ends", eachRow(rows, [](const std::string& row) { return std::string(row.rbegin(), row.rend()); }));
  does("mirror_picks", Rows(rows.rbegin(), rows.rend()));
  Rows turned(8, std::string(8, ' '));
  for (size_t row = 0; row < 8; ++row)
    for (size_t cell = 0; cell < 8; ++cell) turned[row][cell] = rows[7 - cell][row];
  does("turn", turned);
}

TEST_F(DraftSelection, ACopyFillsTheRepeatAndAPartBecomesIt) {
  const Rows part = {before[6].substr(0, 4), before[7].substr(0, 4)};
  weaver.select(0, 0, 1, 3);
  untilSelected("0 0 2 4");
  editor.key("ctrl+c");
  editor.key("ctrl+a");
  editor.edits("the copy is laid side by side", [&] { editor.key("ctrl+shift+v"); });
  Rows filled;
  for (int i = 0; i < 8; ++i) filled.push_back(part[static_cast<size_t>(i % 2)] + part[static_cast<size_t>(i % 2)]);
  EXPECT_EQ(weaver.rows(), filled);
  editor.key("Escape");
  weaver.undo();
  weaver.select(0, 0, 1, 3);
  editor.click("menu.weave");
  editor.edits("the selection becomes the repeat", [&] { editor.click("menu.crop"); });
  EXPECT_EQ(weaver.rows(), part);
  weaver.undo();
  EXPECT_EQ(weaver.rows(), before);
}

}  // namespace
}  // namespace loomlight
