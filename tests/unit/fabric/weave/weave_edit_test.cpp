#include "core/fabric/weave/weave_edit.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/structures.h"

namespace loomlight {
namespace {

/// 3 ends, 4 picks, no symmetry.
Weave motif() {
  return Weave(std::vector<Weave::Row>{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, 0}});
}

TEST(WeaveEdit, APartReachesOverTheEdge) {
  const Weave part = partOf(motif(), {3, 2, 2, 2});
  EXPECT_EQ(part, Weave(std::vector<Weave::Row>{{0, 0}, {0, 1}}));
  EXPECT_EQ(withPart(motif(), 3, 2, part), motif());
}

TEST(WeaveEdit, APartIsLaidWhereItIsPut) {
  const Weave ground = inverted(twill(1, 7));
  const Weave edited = withPart(ground, 6, 7, motif());
  for (int p = 0; p < 8; ++p)
    for (int e = 0; e < 8; ++e) {
      const int alongPicks = (p - 6 + 8) % 8, alongEnds = (e - 7 + 8) % 8;
      const bool inside = alongPicks < 4 && alongEnds < 3;
      EXPECT_EQ(edited.at(p, e), inside ? motif().at(alongPicks, alongEnds) : ground.at(p, e)) << p << ' ' << e;
    }
}

TEST(WeaveEdit, APartLargerThanTheRepeatStopsBeforeItMeetsItself) {
  const Weave large = motif().resized(9, 9);
  EXPECT_EQ(withPart(plainWeave(), 0, 0, large), partOf(large, {0, 0, 2, 2}));
}

TEST(WeaveEdit, APatternStartsAtTheCornerOfItsRectangle) {
  const Weave edited = withPattern(Weave().resized(12, 12), {2, 3, 5, 6}, twill(3, 1));
  EXPECT_EQ(partOf(edited, {2, 3, 5, 6}), partOf(twill(3, 1), {0, 0, 5, 6}));
  EXPECT_EQ(edited.at(1, 3), Weave().warpOver(1, 3));
}

TEST(WeaveEdit, MirrorsTurnsAndInversionsUndoThemselves) {
  const Weave weave = motif();
  EXPECT_EQ(mirroredEnds(weave), Weave(std::vector<Weave::Row>{{0, 0, 1}, {0, 1, 1}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mirroredEnds(mirroredEnds(weave)), weave);
  EXPECT_EQ(mirroredPicks(mirroredPicks(weave)), weave);
  EXPECT_EQ(inverted(inverted(weave)), weave);
  EXPECT_EQ(quarterTurned(quarterTurned(weave)), mirroredEnds(mirroredPicks(weave)));
  EXPECT_EQ(quarterTurned(quarterTurned(quarterTurned(quarterTurned(weave)))), weave);
}

TEST(WeaveEdit, AQuarterTurnToTheRightTakesTheTopToTheRight) {
  // The only warp-over of the top row, at the left, comes to the top of the right column.
  Weave weave = Weave(std::vector<Weave::Row>{{0, 0}, {0, 0}, {1, 0}});
  weave = quarterTurned(weave);
  EXPECT_EQ(weave.ends(), 3);
  EXPECT_EQ(weave.picks(), 2);
  EXPECT_TRUE(weave.at(1, 2));
}

TEST(WeaveEdit, ShiftingByTheRepeatChangesNothing) {
  EXPECT_EQ(shifted(motif(), 3, -4), motif());
  EXPECT_EQ(shifted(twill(2, 2), 1, 1), twill(2, 2));
  EXPECT_EQ(shifted(motif(), 1, 0).at(0, 1), motif().at(0, 0));
}

TEST(WeaveEdit, PicksThatStayAreShared) {
  const Weave ground = twill(3, 1).resized(12, 12);
  const auto made = [&](const Weave& edited) {
    int rows = 0;
    for (int p = 0; p < ground.picks(); ++p) {
      bool isOld = false;
      for (int q = 0; q < ground.picks(); ++q) isOld |= edited.sharedRow(p) == ground.sharedRow(q);
      rows += isOld ? 0 : 1;
    }
    return rows;
  };
  EXPECT_EQ(made(withPart(ground, 10, 3, inverted(partOf(ground, {10, 3, 4, 2})))), 4);
  EXPECT_EQ(made(withPart(ground, 2, 5, partOf(ground, {2, 5, 6, 6}))), 0);
  EXPECT_EQ(made(mirroredPicks(ground)), 0);
  // Twelve picks of four kinds stay four rows.
  const Weave other = inverted(ground);
  EXPECT_EQ(other.sharedRow(1), other.sharedRow(9));
}

TEST(WeaveText, ComesBack) {
  EXPECT_EQ(weaveText(motif()), ".#.\n..#\n##.\n#..\n");
  EXPECT_EQ(weaveFromText(weaveText(motif())), motif());
  EXPECT_EQ(weaveFromText("##\r\n..\r\n"), Weave(std::vector<Weave::Row>{{0, 0}, {1, 1}}));
}

TEST(WeaveText, OtherTextIsNone) {
  for (const char* text : {"", "\n", "#.\n#\n", "hello", "#.\n\n#.", "#x"}) EXPECT_FALSE(weaveFromText(text)) << text;
  EXPECT_FALSE(weaveFromText(std::string(Weave::kMaxSide + 1, '#')));
}

}  // namespace
}  // namespace loomlight
