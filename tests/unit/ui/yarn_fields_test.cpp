#include "ui/inspector/yarn_fields.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(NewStrands, TakeBackTwoThirdsOfTheTwistThatEachHas) {
  const Yarn single;  // 700 turns/m, Z
  Yarn cable = single;
  cable.plies = 2;
  cable.cords = 3;
  twistNewStrands(single, cable);
  EXPECT_EQ(cable.yarnTwist_per_m, 455);
  EXPECT_EQ(cable.yarnTwistDirection, TwistDirection::s);
  EXPECT_EQ(cable.cableTwist_per_m, 296);
  EXPECT_EQ(cable.cableTwistDirection, TwistDirection::z);
}

TEST(NewStrands, KeepTheTwistThatTheyWereGiven) {
  const Yarn single;
  Yarn plied = single;
  plied.plies = 2;
  plied.yarnTwist_per_m = 120;
  twistNewStrands(single, plied);
  EXPECT_EQ(plied.yarnTwist_per_m, 120);
  Yarn parallel = plied;
  parallel.yarnTwist_per_m = 0;
  twistNewStrands(plied, parallel);
  EXPECT_EQ(parallel.yarnTwist_per_m, 0) << "a designer's own nought";
}

}  // namespace
}  // namespace loomlight
