#include "core/fabric/model/weave.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(Weave, DefaultIsPlain) {
  const Weave plain;
  for (int p = -3; p < 4; ++p)
    for (int e = -3; e < 4; ++e) EXPECT_EQ(plain.warpOver(p, e), (p + e) % 2 == 0) << p << " " << e;
}

TEST(Weave, RepeatsForEverInBothDirections) {
  const Weave weave(std::vector<Weave::Row>{{1, 0, 0}, {0, 0, 1}});
  EXPECT_EQ(weave.ends(), 3);
  EXPECT_EQ(weave.picks(), 2);
  EXPECT_TRUE(weave.warpOver(0, 0));
  EXPECT_TRUE(weave.warpOver(-2, -3));
  EXPECT_TRUE(weave.warpOver(4, 9));
  EXPECT_TRUE(weave.warpOver(-1, -1));
  EXPECT_FALSE(weave.warpOver(-1, 0));
}

TEST(Weave, EditSharesUntouchedPicks) {
  const Weave before(std::vector<Weave::Row>(100, Weave::Row(50, 0)));
  const Weave after = before.with(7, 3, true);
  EXPECT_FALSE(before.at(7, 3));
  EXPECT_TRUE(after.at(7, 3));
  for (int p = 0; p < 100; ++p) EXPECT_EQ(before.row(p).data() == after.row(p).data(), p != 7) << p;
  EXPECT_NE(before, after);
  EXPECT_EQ(before, after.with(7, 3, false));
  EXPECT_EQ(before.with(7, 3, false).row(7).data(), before.row(7).data()) << "writing the same value changes nothing";
}

TEST(Weave, ResizedContinuesTheRepeat) {
  const Weave weave(std::vector<Weave::Row>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Weave larger = weave.resized(7, 5);
  for (int p = 0; p < 5; ++p)
    for (int e = 0; e < 7; ++e) EXPECT_EQ(larger.at(p, e), weave.warpOver(p, e));
  EXPECT_EQ(larger.resized(3, 3), weave);
  EXPECT_EQ(weave.resized(3, 6).row(4).data(), weave.row(1).data()) << "rows are shared where their length stays";
}

TEST(Weave, ColumnsAreOfTheEnds) {
  const Weave weave = Weave(std::vector<Weave::Row>{{1, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}}).resized(3, 150);
  const std::vector<uint8_t> columns = weave.columns(2, 5);
  ASSERT_EQ(columns.size(), 5u * 150);
  for (int i = 0; i < 5; ++i)
    for (int p = 0; p < 150; ++p) EXPECT_EQ(columns[i * 150 + p] != 0, weave.warpOver(p, 2 + i)) << p << " " << i;
}

TEST(Weave, EqualityIsOfContent) {
  EXPECT_EQ(Weave(), Weave(std::vector<Weave::Row>{{1, 0}, {0, 1}}));
  EXPECT_NE(Weave(), Weave(std::vector<Weave::Row>{{1, 0}}));
  EXPECT_NE(Weave(), Weave().resized(4, 2));
}

Draft twillDraft() {
  Draft draft;
  draft.shafts = 4;
  draft.treadles = 4;
  draft.threading = {{1}, {2}, {3}, {4}};
  draft.tieUp = {{1, 2}, {2, 3}, {3, 4}, {4, 1}};
  draft.treadling = {{1}, {2}, {3}, {4}};
  return draft;
}

TEST(Drawdown, RaisesTheEndsWhoseShaftIsTiedToThePressedTreadle) {
  const Weave expected(std::vector<Weave::Row>{{1, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 1}, {1, 0, 0, 1}});
  EXPECT_EQ(drawdown(twillDraft()), expected);
}

TEST(Drawdown, SinkingShedComplements) {
  Draft draft = twillDraft();
  draft.risingShed = false;
  const Weave rising = drawdown(twillDraft());
  const Weave sinking = drawdown(draft);
  for (int p = 0; p < 4; ++p)
    for (int e = 0; e < 4; ++e) EXPECT_NE(rising.at(p, e), sinking.at(p, e));
}

TEST(Drawdown, EndOnNoShaftIsNeverUpInEitherShed) {
  for (const bool rising : {true, false}) {
    Draft draft = twillDraft();
    draft.risingShed = rising;
    draft.threading[1] = {};
    draft.threading[2] = {0};
    const Weave weave = drawdown(draft);
    for (int p = 0; p < 4; ++p) {
      EXPECT_FALSE(weave.at(p, 1));
      EXPECT_FALSE(weave.at(p, 2));
    }
  }
}

TEST(Drawdown, PickWithNoTreadleLiftsNothingRisingAndEverythingSinking) {
  Draft draft = twillDraft();
  draft.treadling[2] = {0};
  EXPECT_EQ(drawdown(draft).row(2).size(), 4u);
  for (int e = 0; e < 4; ++e) EXPECT_FALSE(drawdown(draft).at(2, e));
  draft.risingShed = false;
  for (int e = 0; e < 4; ++e) EXPECT_TRUE(drawdown(draft).at(2, e));
}

TEST(Drawdown, LiftplanHasTheLastWordAndIsNeverComplemented) {
  Draft draft = twillDraft();
  draft.liftplan = {{1, 3}, {2, 4}};
  const Weave expected(std::vector<Weave::Row>{{1, 0, 1, 0}, {0, 1, 0, 1}});
  EXPECT_EQ(drawdown(draft), expected);
  draft.risingShed = false;
  EXPECT_EQ(drawdown(draft), expected);
}

TEST(Drawdown, SeveralShaftsAndTreadlesAdd) {
  Draft draft = twillDraft();
  draft.threading[0] = {1, 3};
  draft.treadling = {{1, 3}, {3}};
  const Weave expected(std::vector<Weave::Row>{{1, 1, 1, 1}, {1, 0, 1, 1}});
  EXPECT_EQ(drawdown(draft), expected);
}

TEST(Drawdown, ShaftsAndTreadlesTheLoomLacksArePassedOver) {
  Draft draft = twillDraft();
  draft.threading[0] = {9};
  draft.treadling[1] = {7, 2};
  draft.tieUp[2] = {3, 4, 12};
  const Weave expected(std::vector<Weave::Row>{{0, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 1}, {0, 0, 0, 1}});
  EXPECT_EQ(drawdown(draft), expected);
}

TEST(Drawdown, PicksOfOneShedShareTheirRow) {
  Draft draft = twillDraft();
  draft.treadling.assign(1000, {2});
  const Weave weave = drawdown(draft);
  EXPECT_EQ(weave.row(0).data(), weave.row(999).data());
}

}  // namespace
}  // namespace loomlight
