#include "app/live/turns.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(Turns, WhatCannotBeSeenYetComesFirstAndThePictureBeforeTheLens) {
  EXPECT_EQ(nextTurn({true, 0, 0}, {true, 0, 0}), Turn::picture);
  EXPECT_EQ(nextTurn({true, 8, 0.1}, {true, 0, 9}), Turn::lens);
  EXPECT_EQ(nextTurn({true, 0, 9}, {true, 8, 0}), Turn::picture);
}

TEST(Turns, WhatIsCoarseComesBeforeWhatIsFine) {
  EXPECT_EQ(nextTurn({true, 1, 0}, {true, 4, 9}), Turn::lens);
  EXPECT_EQ(nextTurn({true, 4, 9}, {true, 1, 0}), Turn::picture);
}

TEST(Turns, OneThatWantsNothingLeavesItsTurns) {
  EXPECT_EQ(nextTurn({false, 1, 0}, {true, 1, 9}), Turn::lens);
  EXPECT_EQ(nextTurn({true, 1, 9}, {false, 1, 0}), Turn::picture);
  EXPECT_EQ(nextTurn({true, 1, 9}, {}), Turn::picture);
  EXPECT_EQ(nextTurn({}, {}), Turn::none);
}

// However long their passes are, neither is ever more than one of them ahead of the other.
TEST(Turns, BothGetTheSameTime) {
  constexpr double kPicturePass = 1.0, kLensPass = 0.13;
  Contender picture{true, 1, 0}, lens{true, 1, 0};
  for (int i = 0; i < 200; ++i) {
    (nextTurn(picture, lens) == Turn::lens ? lens.spent_s += kLensPass : picture.spent_s += kPicturePass);
    EXPECT_LE(picture.spent_s - lens.spent_s, kPicturePass + 1e-9);
    EXPECT_LE(lens.spent_s - picture.spent_s, kLensPass + 1e-9);
  }
}

}  // namespace
}  // namespace loomlight
