#include "render/display/stand_in.h"

#include <gtest/gtest.h>

#include <tuple>

namespace loomlight {
namespace {

std::shared_ptr<const Frame> frame(int divider, int samples, const PixelRect& window) {
  Frame made;
  made.width = window.width / divider;
  made.height = window.height / divider;
  made.window = window;
  made.divider = divider;
  made.samples = samples;
  for (int y = 0; y < made.height; ++y)
    for (int x = 0; x < made.width; ++x) {
      const glm::vec2 middle = glm::vec2(window.x, window.y) + (glm::vec2(x, y) + 0.5f) * static_cast<float>(divider);
      made.rgba.emplace_back(middle, 0, 1);
      made.hits.push_back({x + 100 * y, 0, 0, 1.0f});
      if (samples > 1) made.variances.push_back(0.04f);
    }
  return std::make_shared<const Frame>(made);
}

TEST(StandIn, GivesWaySampleBySampleUntilNothingIsLeft) {
  for (const int samples : {0, 1, 16, 1024}) {
    SCOPED_TRACE(samples);
    const StandIn standIn(frame(1, samples, {0, 0, 8, 8}));
    EXPECT_EQ(standIn.share(0), 1.0f);
    for (uint32_t n = 1; n <= standIn.samples(); ++n) EXPECT_LT(standIn.share(n), standIn.share(n - 1));
    EXPECT_EQ(standIn.share(standIn.samples()), 0.0f);
    EXPECT_LE(standIn.samples(), 64u) << "it does not linger";
  }
}

TEST(StandIn, ThePictureIsNeverNoisierThanItWas) {
  const StandIn standIn(frame(1, 16, {0, 0, 8, 8}));
  for (uint32_t n = 0; n <= 16; ++n) {
    SCOPED_TRACE(n);
    const float own = n > 0 ? 0.04f * 16 / static_cast<float>(n) : 0;  // of as much noise in each sample
    EXPECT_LE(standIn.variance(3, 4, n, own), 0.04f * 1.0001f);
    EXPECT_GE(standIn.variance(3, 4, n, own), 0.04f * 0.7f);
  }
}

// A ramp stays the ramp that it is, whatever the resolutions and wherever the window begins.
TEST(StandIn, LiesWhereItsPixelsAre) {
  for (const int own : {1, 2, 8}) {
    const StandIn standIn(frame(own, 0, {16, 32, 64, 48}));
    for (const int divider : {1, 2, 4})
      for (const glm::ivec2 at : {glm::ivec2(24, 40), glm::ivec2(48, 64), glm::ivec2(70, 70)}) {
        const int x = at.x / divider, y = at.y / divider;
        const glm::vec4 light = standIn.light(x, y, divider);
        EXPECT_NEAR(light.x, (static_cast<float>(x) + 0.5f) * static_cast<float>(divider), 1e-4f);
        EXPECT_NEAR(light.y, (static_cast<float>(y) + 0.5f) * static_cast<float>(divider), 1e-4f);
        EXPECT_EQ(standIn.hit(x, y, divider).yarn,
                  (x * divider + divider / 2 - 16) / own + 100 * ((y * divider + divider / 2 - 32) / own));
      }
  }
}

TEST(StandIn, WhatIsNotKeptIsGoneWithTheFirstSample) {
  std::vector<uint8_t> kept(64, 1);
  kept[3 + 8 * 2] = 0;
  const StandIn standIn(frame(1, 0, {0, 0, 8, 8}), 16, kept);
  EXPECT_EQ(standIn.samples(), 16u);
  for (const auto& [x, y, isKept] : {std::tuple(3, 2, false), std::tuple(2, 3, true)}) {
    EXPECT_EQ(standIn.isFineAt(x, y), isKept);
    EXPECT_EQ(standIn.shareAt(x, y, 0), 1.0f);
    EXPECT_EQ(standIn.shareAt(x, y, 1), isKept ? standIn.share(1) : 0.0f);
    EXPECT_EQ(standIn.shareAt(x, y, 16), 0.0f);
  }
}

}  // namespace
}  // namespace loomlight
