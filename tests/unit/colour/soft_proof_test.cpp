#include "render/colour/soft_proof.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace loomlight {
namespace {

TEST(BeyondSrgb, IsWhatHasAChannelWellBelowZero) {
  for (const Rgb within : {Rgb(0), Rgb(1), Rgb(8, 0, 0), Rgb(1, 0.5f, -0.049f), Rgb(-1)})
    EXPECT_FALSE(isBeyondSrgb(within)) << within.r << " " << within.g << " " << within.b;
  for (const Rgb beyond : {Rgb(1, 0.5f, -0.051f), Rgb(-0.2f, 1, 0), Rgb(0.01f, -0.001f, 0)})
    EXPECT_TRUE(isBeyondSrgb(beyond)) << beyond.r << " " << beyond.g << " " << beyond.b;
}

}  // namespace
}  // namespace loomlight
