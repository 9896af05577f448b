#include "core/fabric/weave/draft_edit.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/draft_derivation.h"
#include "core/fabric/weave/jacquard.h"
#include "core/fabric/weave/structures.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using Lists = std::vector<std::vector<int>>;

Fabric drafted(Draft draft) {
  return withDraft(Fabric{}, std::move(draft));
}

/// A point twill: threading 1 2 3 4 3 2, numbered from the back of the loom, so not as its ends come first.
Draft pointDraft() {
  Draft draft = smallestDraft(twill(2, 2));
  draft.threading = {{4}, {3}, {2}, {1}, {2}, {3}};
  return draft;
}

TEST(DraftEdit, AnEndThatChangesItsShaftTakesItsColumnAlong) {
  const Fabric before = drafted(smallestDraft(twill(2, 2)));
  const Fabric after = withDraft(before, withOnlyNumber(*before.draft, DraftPart::threading, 0, 3));
  EXPECT_EQ(after.draft->threading, (Lists{{3}, {2}, {3}, {4}}));
  for (int pick = 0; pick < 4; ++pick) EXPECT_EQ(after.weave.at(pick, 0), before.weave.at(pick, 2)) << pick;
}

TEST(DraftEdit, ATieChangesTheCrossingsOfItsTreadleAndShaft) {
  const Fabric before = drafted(smallestDraft(twill(2, 2).resized(8, 8)));
  const bool tied = hasNumber(*before.draft, DraftPart::tieUp, 1, 3);
  const Fabric after = withDraft(before, withNumber(*before.draft, DraftPart::tieUp, 1, 3, !tied));
  for (int pick = 0; pick < 8; ++pick)
    for (int end = 0; end < 8; ++end)
      EXPECT_EQ(after.weave.at(pick, end) != before.weave.at(pick, end), pick % 4 == 1 && end % 4 == 2);
}

TEST(DraftEdit, NumbersOfALineStaySortedAndSingle) {
  Draft draft = smallestDraft(twill(2, 2));
  draft.treadling[0] = {4};
  draft = withNumber(draft, DraftPart::treadling, 0, 2, true);
  draft = withNumber(draft, DraftPart::treadling, 0, 2, true);
  EXPECT_EQ(draft.treadling[0], (std::vector<int>{2, 4}));
  draft = withNumber(draft, DraftPart::treadling, 0, 4, false);
  EXPECT_EQ(draft.treadling[0], (std::vector<int>{2}));
}

TEST(DraftEdit, FewerShaftsLeaveTheirEndsOnNone) {
  const Draft draft = withShaftCount(smallestDraft(twill(2, 2)), 3);
  EXPECT_EQ(draft.threading, (Lists{{1}, {2}, {3}, {}}));
  const Weave weave = drawdown(draft);
  for (int pick = 0; pick < 4; ++pick) EXPECT_FALSE(weave.at(pick, 3));
  EXPECT_EQ(withTreadleCount(draft, 2).treadling, (Lists{{1}, {2}, {}, {}}));
}

TEST(DraftEdit, AnotherRepeatIsThatOfTheWeave) {
  Random random(9);
  for (int i = 0; i < 50; ++i) {
    const Draft draft = randomDocument(random).draft;
    const Weave weave = drawdown(draft);
    const int ends = 1 + i % 23, picks = 1 + i % 17;
    EXPECT_EQ(drawdown(resized(draft, ends, picks)), weave.resized(ends, picks));
  }
}

TEST(DeriveDraft, WeavesTheWeaveInTheShedAndBySameMeansAsBefore) {
  Random random(11);
  for (int i = 0; i < 100; ++i) {
    const Draft like = randomDocument(random).draft;
    const Weave weave = drawdown(like).with(0, 0, !drawdown(like).at(0, 0));
    const DerivedDraft derived = deriveDraft(weave, {4096, 4096}, like);
    ASSERT_TRUE(derived.draft);
    EXPECT_EQ(drawdown(*derived.draft), weave);
    EXPECT_EQ(derived.draft->liftplan.empty(), like.liftplan.empty());
    EXPECT_TRUE(derived.remark.empty());
  }
}

TEST(DeriveDraft, KeepsTheNumbersOfShaftsAndTreadles) {
  const Draft before = pointDraft();
  EXPECT_EQ(deriveDraft(drawdown(before), {}, before).draft->threading, before.threading);
  EXPECT_EQ(deriveDraft(drawdown(before), {}, before).draft->tieUp, before.tieUp);
  // One crossing more splits one shaft: the end that changed gets the new number, all others keep theirs.
  const Weave weave = drawdown(before);
  const Draft after = *deriveDraft(weave.with(0, 5, !weave.at(0, 5)), {}, before).draft;
  EXPECT_EQ(after.shafts, 5);
  for (size_t end = 0; end < 4; ++end) EXPECT_EQ(after.threading[end], before.threading[end]) << end;
}

TEST(DeriveDraft, SaysWhatALoomCannotDo) {
  const DerivedDraft jacquard = deriveDraft(damaskJacquard(320, 320), {32, 32});
  EXPECT_FALSE(jacquard.draft);
  EXPECT_NE(jacquard.remark.find("more than 32 shafts"), std::string::npos);

  const DerivedDraft lifted = deriveDraft(satin(16, 5), {32, 12});
  ASSERT_TRUE(lifted.draft);
  EXPECT_EQ(lifted.draft->liftplan.size(), 16u);
  EXPECT_NE(lifted.remark.find("16 treadles"), std::string::npos);

  EXPECT_FALSE(deriveDraft(Weave().resized(4000, 4000), {}).draft);
}

TEST(Rewoven, AFabricWithoutADraftGetsNone) {
  EXPECT_FALSE(rewoven(Fabric{}, twill(2, 2), {}).fabric.draft);
  const Fabric fabric = drafted(pointDraft());
  const Rewoven still = rewoven(fabric, twill(3, 1), {});
  EXPECT_EQ(drawdown(*still.fabric.draft), twill(3, 1));
  const Rewoven jacquard = rewoven(fabric, damaskJacquard(320, 320), {});
  EXPECT_FALSE(jacquard.fabric.draft);
  EXPECT_FALSE(jacquard.remark.empty());
}

TEST(Rewoven, ADraftThatNeedsALargerLoomKeepsIt) {
  const Fabric fabric = drafted(smallestDraft(satin(16, 5)));
  const Rewoven edited = rewoven(fabric, fabric.weave.with(3, 3, !fabric.weave.at(3, 3)), {8, 8});
  ASSERT_TRUE(edited.fabric.draft);
  EXPECT_EQ(drawdown(*edited.fabric.draft), edited.fabric.weave);
  EXPECT_TRUE(edited.remark.empty()) << edited.remark;
  const Rewoven larger = rewoven(fabric, satin(17, 5), {8, 8});
  EXPECT_FALSE(larger.fabric.draft);
  EXPECT_NE(larger.remark.find("more than 16 shafts"), std::string::npos) << larger.remark;
}

}  // namespace
}  // namespace loomlight
