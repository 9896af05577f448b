#include "app/bench/bench_targets.h"

#include <gtest/gtest.h>

#include <limits>

namespace loomlight {
namespace {

TEST(Target, RatiosAreToBeLargeAndAllElseSmall) {
  const Target ratio{"memory", "", "", Target::Kind::ratio, 1000, 10000, 3000};
  EXPECT_TRUE(ratio.reaches(ratio.atLeast));
  EXPECT_FALSE(ratio.reaches(ratio.aim));
  const Target difference{"colour", "", "", Target::Kind::percent, 3, 1, 2};
  EXPECT_TRUE(difference.reaches(difference.atLeast));
  EXPECT_FALSE(difference.reaches(difference.aim));
  for (const auto kind :
       {Target::Kind::count, Target::Kind::milliseconds, Target::Kind::flip, Target::Kind::stepBack}) {
    const Target target{"", "", "", kind, 100, 33, 50};
    EXPECT_TRUE(target.reaches(target.atLeast));
    EXPECT_FALSE(target.reaches(target.aim));
  }
}

TEST(Target, WhatWasNotMeasuredReachesNothing) {
  for (const auto kind : {Target::Kind::ratio, Target::Kind::perSecond, Target::Kind::percent, Target::Kind::flip}) {
    const Target target{"", "", "", kind, 3, 1, std::numeric_limits<double>::quiet_NaN()};
    EXPECT_FALSE(target.reaches(target.atLeast));
    EXPECT_FALSE(target.reaches(target.aim));
  }
}

TEST(RatioText, HasThreeDigitsAndNoExponent) {
  EXPECT_EQ(ratioText(3.14159), "3.14 : 1");
  EXPECT_EQ(ratioText(12345.6), "12346 : 1");
  EXPECT_EQ(ratioText(0), "-");
}

}  // namespace
}  // namespace loomlight
