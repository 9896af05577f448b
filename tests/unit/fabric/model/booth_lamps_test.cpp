#include "core/fabric/model/booth_lamps.h"

#include <gtest/gtest.h>

#include <vector>

namespace loomlight {
namespace {

using enum StandardIlluminant;

/// Those that J goes through, from the cloth's own lamp until that comes again.
std::vector<StandardIlluminant> roundFrom(StandardIlluminant own) {
  std::vector<StandardIlluminant> round;
  for (auto lamp = nextLamp(own, {}); lamp && round.size() < 10; lamp = nextLamp(own, lamp)) round.push_back(*lamp);
  return round;
}

TEST(BoothLamps, GoRoundFromTheOwnLampAndBackToIt) {
  EXPECT_EQ(roundFrom(d65), (std::vector{f11, a, ledB3}));
  EXPECT_EQ(roundFrom(a), (std::vector{ledB3, d65, f11}));
  EXPECT_EQ(roundFrom(ledB3), (std::vector{d65, f11, a}));
  for (const StandardIlluminant notInBooth : {f2, blackBody, file})
    EXPECT_EQ(roundFrom(notInBooth), (std::vector{d65, f11, a, ledB3}));
}

}  // namespace
}  // namespace loomlight
