#include "render/share/openness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/random.h"

namespace loomlight {
namespace {

constexpr int kSide = 64;

/// So many rays through each pixel of a cloth that is as open as the function says.
std::vector<ClothRays> raysThrough(uint32_t count, const std::function<double(int x, int y)>& openness) {
  std::vector<ClothRays> pixels;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      ClothRays rays{count, 0};
      Random random(hashCombine(mixBits(uint64_t{17}), y), x);
      for (uint32_t i = 0; i < count; ++i) rays.through += random.uniform() < openness(x, y);
      pixels.push_back(rays);
    }
  return pixels;
}

double rmsError(const Openness& openness, const std::function<double(int x, int y)>& truth) {
  double sum = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) sum += std::pow(openness.at(x, y) - truth(x, y), 2);
  return std::sqrt(sum) / kSide;
}

TEST(Openness, OfPixelsThatAreAlikeIsThatOfAll) {
  for (const double open : {0.05, 0.5}) {
    const auto alike = [&](int, int) { return open; };
    const std::vector<ClothRays> pixels = raysThrough(2, alike);
    const Openness openness(pixels, kSide, kSide, 2);
    // Of two rays alone the error is sqrt(p (1 - p) / 2). Around a pixel are 48 others, and a quarter of them in a
    // corner.
    const double ofSurroundings = std::sqrt(open * (1 - open) / (2 * 48));
    EXPECT_LT(rmsError(openness, alike), 1.5 * ofSurroundings);
    EXPECT_GT(openness.worthOfAround_rays(), 50) << "that is, half of those around";
  }
}

TEST(Openness, OfOpeningsThatAreSeenIsTheirOwn) {
  const auto checked = [](int x, int y) { return (x / 2 + y / 2) % 2 == 0 ? 0.95 : 0.05; };
  const std::vector<ClothRays> pixels = raysThrough(4, checked);
  const Openness openness(pixels, kSide, kSide, 2);
  // What is around is a half, give or take one pixel of 48, which is off by .45. s^2 is .95 x .05, and t^2 is .45^2:
  // worth a quarter of a ray, so that four of its own leave an error of .11 at most.
  EXPECT_NEAR(openness.worthOfAround_rays(), 0.95 * 0.05 / (0.45 * 0.45), 0.03);
  EXPECT_LT(rmsError(openness, checked), std::sqrt(0.95 * 0.05 / 4) + 0.01);
}

TEST(Openness, FollowsWhatChangesSlowly) {
  const auto slope = [](int x, int) { return 0.1 + 0.8 * x / kSide; };
  const std::vector<ClothRays> pixels = raysThrough(2, slope);
  // Two rays of each of 49 pixels are off by sqrt(.25 / 98) = .05 at most, and by half of three pixels' slope, .02,
  // where the picture ends; two rays alone by .31.
  EXPECT_LT(rmsError(Openness(pixels, kSide, kSide, 2), slope), 0.055);
}

// Blocks of four pixels stand in for pixels of four rays.
TEST(Openness, OfSingleRaysIsToldByBlocks) {
  constexpr double kOpen = 0.3;
  const auto alike = [](int, int) { return kOpen; };
  const std::vector<ClothRays> fewRays = raysThrough(1, alike);
  // Around a pixel are 48 others, and a quarter of them in a corner.
  EXPECT_LT(rmsError(Openness(fewRays, kSide, kSide, 2), alike), 1.5 * std::sqrt(kOpen * (1 - kOpen) / 48));
  // Where all of a block is alike, rays do not differ by chance (s^2 is 0), so that each is believed.
  const auto checked = [](int x, int y) { return (x / 8 + y / 8) % 2 == 0 ? 1.0 : 0.0; };
  const std::vector<ClothRays> clearRays = raysThrough(1, checked);
  EXPECT_EQ(rmsError(Openness(clearRays, kSide, kSide, 2), checked), 0);
}

// There are no blocks that are larger.
TEST(Openness, OfASingleRayIsItsOwn) {
  const std::vector<ClothRays> one{{1, 1}};
  EXPECT_EQ(Openness(one, 1, 1, 1).at(0, 0), 1);
}

TEST(Openness, BesideTheClothIsNone) {
  std::vector<ClothRays> pixels = raysThrough(2, [](int, int) { return 1.0; });
  for (int y = 0; y < kSide; ++y)
    for (int x = kSide / 2; x < kSide; ++x) pixels[static_cast<size_t>(y * kSide + x)] = {};
  const Openness openness(pixels, kSide, kSide, 2);
  EXPECT_EQ(openness.at(kSide / 2, 7), 0);
  EXPECT_EQ(openness.at(kSide / 2 - 1, 7), 1) << "what is beside it has no part in it";
}

}  // namespace
}  // namespace loomlight
