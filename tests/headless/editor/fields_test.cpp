/// Typing: where Tab goes, what Enter and Esc do, what one undo takes back, and what is no edit at all.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/headless/editor/weaver.h"

namespace loomlight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Fields : public testing::Test {
 protected:
  Fields() {
    editor.start(smallTwill());
    editor.click("tab.cloth");
  }
  void listens() {
    editor.until("a field listens", [&] { return editor.fact("text_input") == "yes"; });
  }
  /// In the place of what the open field has.
  void types(const std::string& text) {
    listens();
    editor.key("ctrl+a");
    editor.type(text);
  }
  /// And draws what is there then a few times.
  void togglePanels(bool shown) {
    editor.key("p");
    editor.until("P hides and shows the panels", [&] { return editor.shows("draft.select") == shown; });
    for (int i = 0; i < 5; ++i) editor.frame();
  }
  HeadlessEditor editor{{1280, 900, 1}};
};

TEST_F(Fields, TabWalksThroughNumbersAndRenamesNothing) {
  editor.click("cloth.ends_per_cm");
  types("31");
  editor.key("Tab");
  types("20");
  editor.key("Tab");
  types("2.5");
  editor.hold("shift");
  editor.key("Tab");
  editor.let("shift");
  types("21");
  editor.key("Return");
  const Fabric fabric = editor.saved();
  EXPECT_EQ(fabric.ends_per_cm, 31);
  EXPECT_EQ(fabric.picks_per_cm, 21);
  EXPECT_EQ(fabric.settCv_percent, 2.5);
  EXPECT_EQ(fabric.name, "Blue cloth");
  EXPECT_TRUE(editor.shows("draft.select")) << "the panels are gone";
}

TEST_F(Fields, TabGoesOnFromANameAndFromWhereEnterWasPressed) {
  editor.click("cloth.name");
  types("Serge");
  editor.key("Tab");
  types("29");
  editor.key("Return");
  editor.until("Enter commits", [&] { return editor.fact("text_input") == "no"; });
  editor.key("Tab");
  types("19");
  editor.key("Return");
  const Fabric fabric = editor.saved();
  EXPECT_EQ(fabric.name, "Serge");
  EXPECT_EQ(fabric.ends_per_cm, 29);
  EXPECT_EQ(fabric.picks_per_cm, 19);
}

/// Where no field is open Tab opens one: panels are hidden by a key of their own.
TEST_F(Fields, TabHidesNoPanels) {
  editor.key("Tab");
  for (int i = 0; i < 5; ++i) editor.frame();
  ASSERT_TRUE(editor.shows("draft.select")) << "the panels are gone";
  EXPECT_EQ(editor.fact("text_input"), "yes") << "no number is open";
  editor.key("Escape");
  editor.until("Esc leaves the number", [&] { return editor.fact("text_input") == "no"; });
  editor.key("p");
  editor.until("P hides the panels", [&] { return !editor.shows("draft.select"); });
}

/// Random actions once found a number open after an undo, and ctrl+z was for its text: long before, its page was left
/// in the moment in which it was to open.
TEST_F(Fields, ANumberHeldWhilePanelsAreHiddenIsNotOpenAfterwards) {
  editor.move(editor.centre("cloth.ends_per_cm"));
  editor.press();
  togglePanels(false);
  editor.release();
  togglePanels(true);
  EXPECT_EQ(editor.fact("text_input"), "no");
}

TEST_F(Fields, EscapeRestoresANumber) {
  const double before = smallTwill().ends_per_cm;
  editor.click("cloth.ends_per_cm");
  types("77");
  editor.key("Escape");
  EXPECT_EQ(editor.saved().ends_per_cm, before);
}

/// Random actions once left a dialog that no Escape closed: the field that Tab had come to lay behind it.
TEST(FieldsBehindADialog, DoNotKeepItsEscape) {
  HeadlessEditor editor{{960, 600, 1}};  // where the list of presets has room, and not all fields have
  editor.start(smallTwill());
  editor.click("tab.cloth");
  const auto presets = [&] {
    editor.click("presets.browse");
    editor.until("the presets are shown", [&] { return editor.fact("dialog") == "open"; });
    editor.key("Escape");
    editor.untilNoDialogIsOpen();
  };
  const auto goBack = [&] {
    editor.hold("shift");
    editor.key("Tab");
    editor.let("shift");
  };
  editor.click("cloth.press");
  presets();
  for (int i = 0; i < 4; ++i) {
    goBack();
    presets();
    goBack();
    editor.key("x");
    presets();
  }
}

/// It is shown rounded, and opened as it is shown.
TEST(FieldsThatAreOnlyLookedAt, EditNothing) {
  HeadlessEditor editor{{1280, 900, 1}};
  Fabric cloth = smallTwill();
  cloth.ends_per_cm = 20.12345;
  cloth.picks_per_cm = 18.98765;
  for (Yarn& yarn : cloth.yarns) yarn.count_tex = 84.3612;
  editor.start(cloth);
  editor.click("tab.cloth");
  const auto looksAt = [&](const char* field) {
    editor.click(field);
    editor.until("it is open", [&] { return editor.fact("text_input") == "yes"; });
  };
  looksAt("cloth.ends_per_cm");
  editor.key("Return");
  looksAt("cloth.ends_per_cm");
  editor.click("viewport");
  looksAt("cloth.ends_per_cm");
  for (int i = 0; i < 12; ++i) editor.key("Tab");
  editor.key("Escape");
  editor.click("tab.yarn");
  editor.key("Tab");
  for (int i = 0; i < 30; ++i) editor.key("Tab");
  editor.key("Escape");
  EXPECT_EQ(editor.fact("dirty"), "no");
  EXPECT_EQ(editor.savedAs(editor.homeFile("looked at.json")), cloth);
}

TEST_F(Fields, OneUndoTakesBackOneField) {
  const double before = smallTwill().ends_per_cm;
  editor.click("cloth.name");
  types("Serge");
  editor.key("Tab");
  types("31");
  editor.edits("Enter commits", [&] { editor.key("Return"); });
  editor.edits("undo", [&] { editor.key("ctrl+z"); });
  const Fabric fabric = editor.saved();
  EXPECT_EQ(fabric.ends_per_cm, before);
  EXPECT_EQ(fabric.name, "Serge") << "one undo has taken back two edits";
}

/// The click that leaves a field is itself an edit.
TEST_F(Fields, OneUndoTakesBackAStrokeAndNotTheNumberBeforeIt) {
  Weaver weaver(editor);
  editor.click("cloth.ends_per_cm");
  types("31");
  editor.edits("a crossing is turned over", [&] { editor.clickAt(weaver.crossing(0, 0)); });
  editor.until("the number is taken", [&] { return editor.saved().ends_per_cm == 31; });
  const Rows painted = weaver.rows();
  weaver.undo();
  const Fabric once = editor.saved();
  EXPECT_NE(rowsOf(once.weave) == painted, once.ends_per_cm == 31) << "one undo has taken back both, or none";
}

TEST_F(Fields, ASnapshotIsNoEdit) {
  editor.key("ctrl+p");
  editor.enter("snapshot.width", "200");
  editor.enter("snapshot.samples_per_pixel", "1");
  editor.key("Escape");
  EXPECT_EQ(editor.fact("dirty"), "no");
  editor.edits("an edit", [&] { editor.enter("cloth.ends_per_cm", "27"); });
  const Fabric saved = editor.saved();
  EXPECT_EQ(saved.render.width, 200) << "the size is remembered all the same";
}

/// Pixels or mm: nothing moves under the mouse, so that a second click means what the first one meant.
TEST_F(Fields, AChangeOfUnitsMovesNoRow) {
  editor.key("ctrl+p");
  const HeadlessEditor::Rect before = editor.rect("snapshot.size_in/Print, mm"), file = editor.rect("snapshot.file");
  editor.click("snapshot.size_in/Print, mm");
  editor.until("sizes are in mm", [&] { return editor.shows("snapshot.width_mm"); });
  EXPECT_EQ(editor.rect("snapshot.size_in/Print, mm"), before);
  EXPECT_EQ(editor.rect("snapshot.file"), file);
}

class Orders : public Fields {
 protected:
  Orders() { editor.click("draft.tab_colours"); }
  std::vector<int> warp() { return editor.saved().warpSequence; }
  /// The page of colours is longer than its room.
  void bringUp(const std::string& widget) {
    const HeadlessEditor::Rect tab = editor.rect("draft.tab_structures");
    const ImVec2 page(tab.x1, tab.y1 + 60);
    const float end = tab.y1 + 220;
    for (int i = 0; i < 40; ++i) {
      const bool below = !editor.shows(widget) || editor.rect(widget).y1 > end;
      if (!below && editor.rect(widget).y0 > tab.y1 + 8) return;
      editor.wheelAt(page, below ? -1.0f : 1.0f);
    }
  }
};

TEST_F(Orders, AYarnThatIsNotThereIsRefusedAndOffered) {
  ASSERT_EQ(smallTwill().yarns.size(), 2u);
  const std::vector<int> before = warp();
  editor.enter("draft.warp_order", "6A 4C");
  editor.until("it is refused", [&] { return editor.fact("draft.warp_order_problem") == "There is no yarn C yet."; });
  EXPECT_EQ(warp(), before) << "a part of it was taken";
  editor.edits("the yarn is added", [&] { editor.click("draft.warp_order_add"); });
  const Fabric fabric = editor.saved();
  EXPECT_THAT(fabric.warpSequence, ElementsAre(0, 0, 0, 0, 0, 0, 2, 2, 2, 2));
  EXPECT_EQ(fabric.yarns.size(), 3u);
  EXPECT_EQ(editor.fact("draft.warp_order_problem"), "");
}

/// A letter that is far away is a slip: nobody wants all yarns between.
TEST_F(Orders, AYarnBeyondTheNextIsNamedAndNotOffered) {
  const std::vector<int> before = warp();
  editor.enter("draft.warp_order", "6A 4Z");
  editor.until("it is refused",
               [&] { return editor.fact("draft.warp_order_problem") == "There is no yarn Z; next is C."; });
  EXPECT_FALSE(editor.shows("draft.warp_order_add"));
  EXPECT_EQ(warp(), before);
  editor.enter("draft.warp_order", "4A 4C 4D");
  editor.until("two that follow are offered", [&] { return editor.shows("draft.warp_order_add"); });
  editor.edits("they are added", [&] { editor.click("draft.warp_order_add"); });
  EXPECT_EQ(editor.saved().yarns.size(), 4u);
}

TEST_F(Orders, WhatIsNoOrderIsRefusedAloudAndStaysToBeMended) {
  const std::vector<int> before = warp();
  editor.enter("draft.warp_order", "4A 2(B");
  editor.until("it is refused", [&] { return !editor.fact("draft.warp_order_problem").empty(); });
  EXPECT_EQ(warp(), before);
  editor.click("draft.warp_order");
  editor.type(")");
}

TEST_F(Orders, StripesAreSetByThreadsOrByWidth) {
  editor.edits("an order", [&] { editor.enter("draft.warp_order", "4A 6B"); });
  bringUp("order.stripe_0_threads");
  editor.edits("threads", [&] { editor.enter("order.stripe_0_threads", "8"); });
  EXPECT_THAT(warp(), ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1));
  bringUp("order.stripe_1_cm");
  editor.edits("a width, to whole threads", [&] { editor.enter("order.stripe_1_cm", "0.25"); });
  EXPECT_EQ(warp().size(), 8 + std::lround(0.25 * smallTwill().ends_per_cm));
  bringUp("order.stripe_0_threads");
  EXPECT_EQ(editor.fact("order.stripe_0_threads"), "8 ends");
  editor.edits("one", [&] { editor.enter("order.stripe_0_threads", "1"); });
  editor.until("one is an end", [&] { return editor.fact("order.stripe_0_threads") == "1 end"; });
  editor.edits("ends again", [&] { editor.enter("order.stripe_0_threads", "7 ends"); });
  editor.until("they are taken", [&] { return editor.fact("order.stripe_0_threads") == "7 ends"; });
}

TEST_F(Orders, AnEdgeIsDraggedInTheBar) {
  editor.edits("an order", [&] { editor.enter("draft.warp_order", "4A 6B 2A"); });
  bringUp("order.bar");
  const HeadlessEditor::Rect bar = editor.rect("order.bar");
  const float thread = (bar.x1 - bar.x0) / 12;
  editor.edits("the first edge", [&] { editor.dragWidget("order.edge_0", 2 * thread); });
  EXPECT_THAT(warp(), ElementsAre(0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0)) << "the other stripes stay where they are";
  editor.edits("one step of undo", [&] { editor.key("ctrl+z"); });
  EXPECT_THAT(warp(), ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0));
  editor.edits("far beyond its neighbour", [&] { editor.dragWidget("order.edge_0", -40 * thread); });
  EXPECT_THAT(warp(), ElementsAre(0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0)) << "every stripe keeps a thread";
}

TEST_F(Orders, WhatWasRefusedIsGoneWithItsCloth) {
  editor.key("ctrl+n");
  editor.until("a new cloth", [&] { return editor.fact("name") != "Blue cloth"; });
  editor.enter("draft.warp_order", "2(A");
  editor.until("it is refused", [&] { return !editor.fact("draft.warp_order_problem").empty(); });
  editor.key("ctrl+n");
  editor.until("another new cloth", [&] { return editor.fact("draft.warp_order_problem").empty(); });
}

TEST_F(Orders, WhatTheyComeToStandsBesideTheirNamesAndOnlyAProblemTakesALine) {
  editor.edits("an order", [&] { editor.enter("draft.warp_order", "4A 6B"); });
  editor.frame();
  const HeadlessEditor::Rect field = editor.rect("draft.warp_order"), threads = editor.rect("draft.warp_order_threads");
  EXPECT_LE(threads.y1, field.y0);
  EXPECT_FALSE(editor.shows("draft.warp_order_line"));
  const float next = editor.rect("draft.weft_order").y0;
  editor.enter("draft.warp_order", "4A 2(B");
  editor.until("it is refused", [&] { return editor.shows("draft.warp_order_line"); });
  EXPECT_GE(editor.rect("draft.warp_order_line").y0, field.y1);
  EXPECT_GT(editor.rect("draft.weft_order").y0, next);
}

/// In a window as most have it, of orders that take a line each.
TEST(OrdersAtUsualSize, TheTableOpensAboveTheFold) {
  HeadlessEditor editor({1440, 900});
  Fabric fabric = smallTwill();
  fabric.warpSequence = {0, 0, 0, 0, 1, 1};
  editor.start(fabric);
  editor.click("draft.tab_colours");
  editor.until("stripes are shown", [&] { return editor.shows("order.stripe_1_threads"); });
  EXPECT_LE(editor.rect("order.stripe_1_threads").y1, editor.rect("presets.browse").y0);
  const HeadlessEditor::Rect tab = editor.rect("draft.tab_colours");
  editor.click("draft.tab_loom");
  editor.frame();
  EXPECT_EQ(editor.rect("draft.tab_colours"), tab) << "tabs stay under the mouse";
}

/// A wider stripe may make the order above a line longer: the bar waits for the mouse to let go.
TEST_F(Orders, TheBarStaysUnderTheMouseThatDragsIt) {
  const auto height = [&](const std::string& order) {
    editor.edits(order, [&] { editor.enter("draft.warp_order", order); });
    editor.frame();
    const HeadlessEditor::Rect field = editor.rect("draft.warp_order");
    return field.y1 - field.y0;
  };
  const float one = height("2B");
  // As many stripes as one line has room for, and then as many of two digits: the last, of one, is one digit short of a
  // second line.
  constexpr std::array kWidths{9, 4, 7, 2, 5, 8, 3, 6, 9, 7, 2, 8, 4, 6, 3, 5, 9, 2, 7, 4};  // no repeat in them
  const auto order = [&](int wide, int stripes) {
    std::string text;
    for (int i = 0; i < stripes; ++i)
      text += fmt::format("{}{}{}", i > 0 ? " " : "", kWidths[i] + (i < wide ? 10 : 0), i % 2 == 0 ? 'A' : 'B');
    return text;
  };
  int stripes = 4, wide = 0;
  while (height(order(0, stripes + 1)) == one) ASSERT_LT(++stripes, static_cast<int>(kWidths.size()));
  while (wide + 1 < stripes && height(order(wide + 1, stripes)) == one) ++wide;
  ASSERT_LT(wide + 1, stripes);
  height(order(wide, stripes));
  const size_t sizeBefore = warp().size();
  bringUp("order.bar");
  const HeadlessEditor::Rect bar = editor.rect("order.bar");
  const ImVec2 edge(bar.x1 - 2, 0.5f * (bar.y0 + bar.y1));  // of the last stripe
  editor.move(edge);
  editor.press();
  editor.edits("the last stripe grows", [&] { editor.move(ImVec2(edge.x + 300, edge.y)); });
  EXPECT_EQ(editor.rect("order.bar").y0, bar.y0);
  EXPECT_GT(warp().size(), sizeBefore);
  editor.release();
  EXPECT_GT(editor.rect("order.bar").y0, bar.y0) << "the order takes another line";
}

TEST_F(Orders, StripesAreColouredAddedAndTakenAway) {
  editor.edits("an order", [&] { editor.enter("draft.warp_order", "4A 6B"); });
  bringUp("order.stripe_1_add");
  editor.edits("one more", [&] { editor.click("order.stripe_1_add"); });
  EXPECT_THAT(warp(), ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0));
  bringUp("order.stripe_1_colour");
  editor.click("order.stripe_1_colour");
  editor.edits("of the other yarn", [&] { editor.click("order.stripe_1_yarn_0"); });
  EXPECT_EQ(warp(), std::vector<int>(16, 0));
  EXPECT_TRUE(editor.shows("order.stripe_2_threads")) << "three stripes of one yarn are three rows yet";
  bringUp("order.stripe_1_remove");
  editor.edits("taken away", [&] { editor.click("order.stripe_1_remove"); });
  EXPECT_EQ(warp(), std::vector<int>(10, 0));
}

TEST_F(Orders, TheOtherSystemIsCopiedAndTheOrderIsRepeated) {
  editor.edits("an order", [&] { editor.enter("draft.warp_order", "2A 2B"); });
  bringUp("order.repeat");
  editor.edits("once more", [&] { editor.click("order.repeat"); });
  EXPECT_EQ(warp().size(), 8u);
  bringUp("order.system/Weft");
  editor.click("order.system/Weft");
  bringUp("order.copy");
  editor.edits("as in a tartan", [&] { editor.click("order.copy"); });
  const Fabric fabric = editor.saved();
  EXPECT_EQ(fabric.weftSequence, fabric.warpSequence);
}

TEST_F(Orders, AnOrderIsOneStepOfUndo) {
  const std::vector<int> before = warp();
  editor.edits("an order", [&] { editor.enter("draft.warp_order", "4(2A 2B) 3A 4B"); });
  EXPECT_EQ(warp().size(), 23u);
  editor.edits("undo", [&] { editor.key("ctrl+z"); });
  EXPECT_EQ(warp(), before);
}

}  // namespace
}  // namespace loomlight
