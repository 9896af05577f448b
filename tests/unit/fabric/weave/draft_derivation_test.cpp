#include "core/fabric/weave/draft_derivation.h"

#include <gtest/gtest.h>

#include <set>

#include "core/fabric/weave/jacquard.h"
#include "core/fabric/weave/structures.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using Lists = std::vector<std::vector<int>>;

TEST(SmallestDraft, OfATwillIsStraight) {
  const Draft draft = smallestDraft(twill(2, 2).resized(8, 8));
  EXPECT_EQ(draft.shafts, 4);
  EXPECT_EQ(draft.treadles, 4);
  EXPECT_EQ(draft.threading, (Lists{{1}, {2}, {3}, {4}, {1}, {2}, {3}, {4}}));
  EXPECT_EQ(draft.treadling, (Lists{{1}, {2}, {3}, {4}, {1}, {2}, {3}, {4}}));
}

TEST(SmallestDraft, WeavesItsWeaveOnAsManyShaftsAsThereAreKindsOfEnds) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    // Few kinds of ends and picks, at random, so that there is something to group.
    const Weave weave = drawdown(randomDocument(random).draft);
    const Draft draft = smallestDraft(weave);
    EXPECT_EQ(drawdown(draft), weave);
    std::set<std::vector<bool>> ends, picks;
    for (int e = 0; e < weave.ends(); ++e) {
      std::vector<bool> column;
      for (int p = 0; p < weave.picks(); ++p) column.push_back(weave.at(p, e));
      ends.insert(column);
    }
    for (int p = 0; p < weave.picks(); ++p) picks.insert({weave.row(p).begin(), weave.row(p).end()});
    EXPECT_EQ(static_cast<size_t>(draft.shafts), ends.size());
    EXPECT_EQ(static_cast<size_t>(draft.treadles), picks.size());
  }
}

TEST(SmallestDraft, OfAJacquardHasItsHundredsOfShafts) {
  const Weave weave = damaskJacquard(320, 320);
  const Draft draft = smallestDraft(weave);
  EXPECT_GT(draft.shafts, 100);
  EXPECT_EQ(drawdown(draft), weave);
}

TEST(SmallestDraft, OfOneSideOnlyHasOneShaft) {
  const Draft draft = smallestDraft(Weave(std::vector<Weave::Row>(3, Weave::Row(5, 0))));
  EXPECT_EQ(draft.shafts, 1);
  EXPECT_EQ(draft.treadles, 1);
  EXPECT_TRUE(draft.tieUp[0].empty());
}

TEST(DraftConversions, WeaveTheSameCloth) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Draft draft = randomDocument(random).draft;
    const Weave weave = drawdown(draft);
    SCOPED_TRACE(i);
    EXPECT_EQ(drawdown(withLiftplan(draft)), weave);
    EXPECT_TRUE(withLiftplan(draft).treadling.empty());
    EXPECT_EQ(drawdown(withTreadles(draft)), weave);
    EXPECT_TRUE(withTreadles(draft).liftplan.empty());
    for (const bool rising : {true, false}) {
      EXPECT_EQ(withShed(draft, rising).risingShed, rising);
      EXPECT_EQ(drawdown(withShed(draft, rising)), weave);
      EXPECT_EQ(drawdown(withShed(withTreadles(draft), rising)), weave);
    }
  }
}

TEST(DraftConversions, AnotherShedKeepsTreadlingAndComplementsTheTieUp) {
  Draft draft;
  draft.shafts = draft.treadles = 4;
  draft.threading = {{1}, {2}, {3}, {4}};
  draft.tieUp = {{1, 2}, {2, 3}, {3, 4}, {1, 4}};
  draft.treadling = {{4}, {1}, {2}};
  const Draft sinking = withShed(draft, false);
  EXPECT_EQ(sinking.treadling, draft.treadling);
  EXPECT_EQ(sinking.tieUp, (Lists{{3, 4}, {1, 4}, {1, 2}, {2, 3}}));
  EXPECT_EQ(withShed(sinking, true), draft);
}

}  // namespace
}  // namespace loomlight
