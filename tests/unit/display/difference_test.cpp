#include "render/display/difference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace loomlight {
namespace {

constexpr int kPatchWidth = 40, kPatchHeight = 30;
constexpr PixelRect kWindow{10, 5, 24, 20};

/// A grey film of noise around `brightness` of the pixel.
template <class Brightness>
Film noise(Brightness&& brightness, uint32_t samples, uint64_t seed) {
  Film film(kPatchWidth, kPatchHeight);
  Random random(seed);
  for (int y = 0; y < kPatchHeight; ++y)
    for (int x = 0; x < kPatchWidth; ++x)
      for (uint32_t i = 0; i < samples; ++i) {
        PathSample sample;
        sample.alpha = 1;
        sample.direct = Rgb(brightness(x, y) * 2 * random.uniform());
        film.add(x, y, i, sample);
      }
  return film;
}

float level(const Difference& difference, int x, int y) {
  return difference.map[static_cast<size_t>(y) * difference.width + x].g;
}

TEST(Difference, IsUnknownBeforeBothHaveASpread) {
  const auto half = [](int, int) { return 0.5f; };
  EXPECT_FALSE(differenceOf(noise(half, 1, 1), noise(half, 8, 2), kWindow));
  EXPECT_FALSE(differenceOf(noise(half, 8, 1), noise(half, 1, 2), kWindow));
  EXPECT_FALSE(differenceOf(noise(half, 8, 1), noise([](int, int) { return 0.0f; }, 8, 2), kWindow));
  EXPECT_TRUE(differenceOf(noise(half, 2, 1), noise(half, 2, 2), kWindow));
}

TEST(Difference, NamesTheMeanAndHowSureItIs) {
  const auto found =
      differenceOf(noise([](int, int) { return 0.53f; }, 64, 1), noise([](int, int) { return 0.5f; }, 64, 2), kWindow);
  ASSERT_TRUE(found);
  // A sample is uniform in [0, 2b]: its deviation is b / sqrt(3). Of 480 pixels of 64 samples each, in both pictures.
  const double expected = 100 * std::hypot(0.53, 0.5) / 0.5 / std::sqrt(3.0 * 480 * 64);
  EXPECT_NEAR(found->error_percent, expected, 0.1 * expected);
  EXPECT_NEAR(found->mean_percent, 6, 4 * expected);
}

TEST(Difference, NoiseAloneLeavesTheMapBlack) {
  const auto half = [](int, int) { return 0.5f; };
  const auto found = differenceOf(noise(half, 16, 3), noise(half, 16, 4), kWindow);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->map.size(), 24u * 20u);
  int lit = 0;
  for (const glm::vec4& pixel : found->map) lit += pixel.r + pixel.g + pixel.b > 0.01f;
  EXPECT_LT(lit, 48) << "two standard errors leave one pixel in twenty";
}

TEST(Difference, ShowsWhereItIs) {
  const auto truth = noise([](int, int) { return 0.5f; }, 200, 5);
  const auto stain = [](int x, int) { return x >= 22 ? 0.75f : 0.5f; };
  const auto found = differenceOf(noise(stain, 200, 6), truth, kWindow);
  ASSERT_TRUE(found);
  EXPECT_LT(level(*found, 4, 10), 0.02f);
  EXPECT_GT(level(*found, 20, 10), 0.5f) << "half as bright again is off the scale, but for what noise may explain";
  EXPECT_EQ(found->map[0].a, 1);
}

}  // namespace
}  // namespace loomlight
