#include "core/fabric/weave/turned_over.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/structures.h"

namespace loomlight {
namespace {

TEST(TurnedOver, EveryCrossingIsThatOfTheBackBehindIt) {
  Fabric fabric;
  fabric.weave = twill({2, 1, 1, 3}, 2, Slant::z);
  fabric.yarns.resize(3);
  fabric.warpSequence = {0, 1, 1, 2, 0};
  fabric.weftSequence = {0, 2};
  const Fabric back = turnedOver(fabric);
  for (int pick = -9; pick < 20; ++pick)
    for (int end = -11; end < 20; ++end) {
      EXPECT_NE(back.weave.warpOver(pick, turnedEnd(end)), fabric.weave.warpOver(pick, end)) << pick << ' ' << end;
      EXPECT_EQ(back.warpYarn(turnedEnd(end)), fabric.warpYarn(end));
      EXPECT_EQ(back.weftYarn(pick), fabric.weftYarn(pick));
    }
  EXPECT_EQ(turnedOver(back), fabric) << "twice is not once round";
}

}  // namespace
}  // namespace loomlight
