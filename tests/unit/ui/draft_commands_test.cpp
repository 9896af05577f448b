#include "ui/draft/draft_commands.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/draft_derivation.h"

namespace loomlight {
namespace {

/// A context of Dear ImGui, whose clipboard works without a window.
class DraftCommands : public testing::Test {
 protected:
  DraftCommands() : context_(ImGui::CreateContext()) { fabric_.weave = twill(3, 1).resized(8, 8); }
  ~DraftCommands() override { ImGui::DestroyContext(context_); }

  /// The weave after the command; the same where it does not edit.
  Weave after(DraftCommand command) {
    if (auto edited = runDraftCommand(command, fabric_, preferences_, view_)) fabric_ = std::move(*edited);
    return fabric_.weave;
  }

  ImGuiContext* context_;
  Fabric fabric_;
  DraftPreferences preferences_;
  DraftView view_;
};

TEST_F(DraftCommands, WhatIsCopiedIsPastedAtTheSelection) {
  const Weave before = fabric_.weave;
  view_.selection = CellRect{0, 1, 2, 3};
  EXPECT_EQ(after(DraftCommand::copy), before);
  view_.selection = CellRect{7, 6, 1, 1};
  const Weave pasted = after(DraftCommand::paste);
  EXPECT_EQ(pasted, withPart(before, 7, 6, partOf(before, {0, 1, 2, 3})));
  EXPECT_EQ(view_.selection, (CellRect{7, 6, 2, 3}));
}

TEST_F(DraftCommands, CutLeavesTheWeftOnTop) {
  const Weave before = fabric_.weave;
  view_.selection = CellRect{2, 2, 3, 3};
  const Weave cut = after(DraftCommand::cut);
  for (int p = 0; p < 8; ++p)
    for (int e = 0; e < 8; ++e) EXPECT_EQ(cut.at(p, e), before.at(p, e) && !view_.selection->contains(p, e));
  EXPECT_EQ(after(DraftCommand::paste), before);
}

TEST_F(DraftCommands, ACopyFillsTheSelectionAgainAndAgain) {
  ImGui::SetClipboardText("#.\n.#\n");
  view_.selection.reset();
  const Weave filled = after(DraftCommand::fillWithCopy);
  for (int p = 0; p < 8; ++p)
    for (int e = 0; e < 8; ++e) EXPECT_EQ(filled.at(p, e), (p + e) % 2 == 1);
}

TEST_F(DraftCommands, AnotherTextOnTheClipboardPastesNothing) {
  const Weave before = fabric_.weave;
  ImGui::SetClipboardText("a shopping list");
  EXPECT_EQ(after(DraftCommand::paste), before);
  EXPECT_FALSE(view_.selection);
}

TEST_F(DraftCommands, EditsStayWithinTheSelection) {
  for (const DraftCommand command : {DraftCommand::invert, DraftCommand::mirrorEnds, DraftCommand::mirrorPicks,
                                     DraftCommand::quarterTurn, DraftCommand::shiftUp, DraftCommand::shiftLeft}) {
    const Weave before = fabric_.weave;
    view_.selection = CellRect{1, 2, 3, 3};
    const Weave edited = after(command);
    EXPECT_FALSE(edited == before) << static_cast<int>(command);
    for (int p = 0; p < 8; ++p)
      for (int e = 0; e < 8; ++e)
        if (!CellRect{1, 2, 3, 3}.contains(p, e)) {
          EXPECT_EQ(edited.at(p, e), before.at(p, e));
        }
  }
}

TEST_F(DraftCommands, ShiftsGoWhereTheArrowPoints) {
  fabric_.weave = Weave(std::vector<Weave::Row>{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  preferences_.origin = DraftPreferences::Origin::topRight;  // ends grow to the left, picks downwards
  EXPECT_TRUE(after(DraftCommand::shiftLeft).at(0, 1));
  EXPECT_TRUE(after(DraftCommand::shiftDown).at(1, 1));
  view_.back = true;  // the ends turn round
  EXPECT_TRUE(after(DraftCommand::shiftLeft).at(1, 0));
}

TEST_F(DraftCommands, TheDraftFollows) {
  fabric_ = withDraft(fabric_, smallestDraft(fabric_.weave));
  const Weave edited = after(DraftCommand::invert);
  ASSERT_TRUE(fabric_.draft);
  EXPECT_EQ(drawdown(*fabric_.draft), edited);
}

TEST_F(DraftCommands, TheSelectionBecomesTheRepeat) {
  const Weave before = fabric_.weave;
  view_.selection = CellRect{6, 6, 4, 4};
  EXPECT_EQ(after(DraftCommand::repeatSelection), partOf(before, {6, 6, 4, 4}));
  EXPECT_FALSE(view_.selection);
}

}  // namespace
}  // namespace loomlight
