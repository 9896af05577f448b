#include "app/export/handover/surface_samples.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

/// Every pixel has a colour of its own; in the mirror image, that of the pixel that it is the image of.
SideMaps colouredPixels(bool isMirrored) {
  constexpr int kWidth = 24, kHeight = 20;
  SideMaps side;
  side.tile.width = kWidth;
  side.tile.height = kHeight;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int column = isMirrored ? kWidth - 1 - x : x;
      side.tile.opacity.push_back(1);
      side.tile.normal.emplace_back(0, 0, 1);
      side.tile.yarn.push_back(0);
      side.along.emplace_back(1, 0);
      side.reflected.emplace_back(0.001f * static_cast<float>(y * kWidth + column + 1));
      side.transmitted.emplace_back(0.1f);
    }
  return side;
}

TEST(SurfaceSamples, AClothThatIsTurnedOverIsSeenAtTheSamePoints) {
  const auto samples = surfaceSamples(colouredPixels(false), Fabric{}, 16);
  const auto twin = surfaceSamples(colouredPixels(true), Fabric{}, 16);
  ASSERT_EQ(samples.size(), 16U);
  for (size_t i = 0; i < samples.size(); ++i)
    EXPECT_NEAR(samples[i].point.reflected.x, twin[i ^ 1].point.reflected.x, 1e-5) << i;
}

}  // namespace
}  // namespace loomlight
