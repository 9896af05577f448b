#include "app/live/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/transport/path_tracer.h"
#include "tests/support/refining_test.h"
#include "tests/support/watched_medium.h"

namespace loomlight {
namespace {

class RefinementTest : public test::RefiningTest {};

TEST_F(RefinementTest, TheWholeHasTheSamplesOfTheRenderer) {
  Refinement refinement(cloth, kWidth, kHeight, {});
  EXPECT_FALSE(refinement.begun());
  refine(refinement, 1);
  Film film(kWidth, kHeight);
  renderUpTo(refinement.samples(), *cloth.scene, *cloth.medium,
             CameraRays(cloth.scene->fabric->camera, kWidth, kHeight), film, Task{});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) EXPECT_EQ(refinement.film().mean(x, y), film.mean(x, y));
  const Frame frame = refinement.frame();
  EXPECT_EQ(frame.hits.size(), static_cast<size_t>(kWidth) * kHeight);
  EXPECT_EQ(frame.samples, static_cast<int>(refinement.samples()));
}

TEST_F(RefinementTest, AWindowTracesItsPixelsOnlyAndFindsThemAgain) {
  Refinement refinement(cloth, kWidth, kHeight, {.asTraced = true});
  const PixelRect first{4, 6, 20, 16}, second{30, 20, 20, 16};
  refinement.look(first);
  refine(refinement, 2);
  const uint32_t had = refinement.samples();
  EXPECT_EQ(refinement.film().samples(4, 6), had);
  EXPECT_EQ(refinement.film().samples(3, 6), 0u);
  EXPECT_EQ(refinement.film().samples(24, 21), 0u);

  refinement.look(second);
  EXPECT_FALSE(refinement.begun());
  refine(refinement, 1);
  const PixelRect between{10, 10, 30, 14};  // parts of both, and what neither has seen
  refinement.look(between);
  EXPECT_FALSE(refinement.begun());
  ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  const Frame frame = refinement.frame();
  EXPECT_EQ(frame.rgba.size(), 30u * 14u);
  EXPECT_TRUE(frame.hits.empty());
  const auto seen = std::count_if(frame.rgba.begin(), frame.rgba.end(), [](const glm::vec4& p) { return p.a > 0; });
  EXPECT_GT(seen, 0.8 * 30 * 14) << "coarse pixels stand in, but for a few that look between the yarns";

  refinement.look(first);
  EXPECT_TRUE(refinement.begun());
  EXPECT_EQ(refinement.samples(), had);
}

TEST_F(RefinementTest, RestsAtTheSamplesAskedForAndGoesOnWhereMoreAreWanted) {
  Refinement refinement(cloth, kWidth, kHeight, {});
  const auto untilAtRest = [&] {
    while (!refinement.converged()) ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  };
  refinement.restAt(3);
  untilAtRest();
  EXPECT_EQ(refinement.samples(), 3u);
  refinement.restAt(5);
  EXPECT_FALSE(refinement.converged());
  untilAtRest();
  EXPECT_EQ(refinement.samples(), 5u);
  refinement.restAt(2);
  EXPECT_TRUE(refinement.converged());
  EXPECT_EQ(refinement.samples(), 5u) << "those that there are stay";
}

TEST_F(RefinementTest, DoesNotRestBeforeWhatStandsInIsGone) {
  constexpr int kEarlier = 6;
  Frame earlier;
  earlier.width = kWidth;
  earlier.height = kHeight;
  earlier.window = {0, 0, kWidth, kHeight};
  earlier.samples = kEarlier;
  earlier.rgba.resize(size_t{kWidth} * kHeight);
  earlier.hits.resize(earlier.rgba.size());
  Refinement refinement(cloth, kWidth, kHeight, {});
  refinement.standIn(std::make_shared<const Frame>(earlier));
  refinement.skipCoarse();
  refinement.restAt(2);
  while (!refinement.converged()) ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  EXPECT_FALSE(refinement.fading());
  EXPECT_EQ(refinement.samples(), static_cast<uint32_t>(kEarlier));
}

TEST_F(RefinementTest, ACoarseWindowCoversAllThatWasAskedFor) {
  Refinement refinement(cloth, kWidth, kHeight, {.secondsPerPath = 1e-3});  // so slow a cloth begins coarsely
  const PixelRect window{13, 7, 30, 22};
  refinement.look(window);
  ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  const Frame frame = refinement.frame();
  ASSERT_GT(frame.divider, 1);
  EXPECT_LE(frame.window.x, window.x);
  EXPECT_LE(frame.window.y, window.y);
  EXPECT_GE(frame.window.x + frame.window.width, window.x + window.width);
  EXPECT_GE(frame.window.y + frame.window.height, window.y + window.height);
  EXPECT_EQ(frame.reach(), frame.window) << "whole pixels, as the viewport is larger";
  EXPECT_EQ(frame.rgba.size(), static_cast<size_t>(frame.width) * frame.height);
}

// Else what is coarse, and what it stands in for, would lie apart by the more the farther from the corner.
TEST_F(RefinementTest, ACoarsePixelStandsForWholeFineOnes) {
  constexpr int kDivider = 7, kColumns = 9, kRows = 7;  // 63 x 49 of 60 x 44
  Refinement refinement(cloth, kWidth, kHeight, {.secondsPerPath = 1e-3});
  refinement.beginWith({kDivider, 1e9});
  ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  const Frame frame = refinement.frame();
  ASSERT_EQ(frame.divider, kDivider);
  EXPECT_EQ(frame.window, (PixelRect{0, 0, kWidth, kHeight}));
  EXPECT_EQ(frame.reach(), (PixelRect{0, 0, kColumns * kDivider, kRows * kDivider}));
  Film film(kColumns, kRows);
  renderUpTo(1, *cloth.scene, *cloth.medium, CameraRays(cloth.scene->fabric->camera, kWidth, kHeight, kDivider), film,
             Task{});
  ASSERT_EQ(frame.rgba.size(), size_t{kColumns} * kRows);
  for (int y = 0; y < kRows; ++y)
    for (int x = 0; x < kColumns; ++x)
      EXPECT_EQ(Rgb(frame.rgba[static_cast<size_t>(y) * kColumns + static_cast<size_t>(x)]), film.mean(x, y));
}

TEST_F(RefinementTest, AStoppedPassLosesNothing) {
  Refinement refinement(cloth, kWidth, kHeight, {});
  refine(refinement, 1);
  const uint32_t had = refinement.samples();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(refinement.advance(Task{stop.get_token(), {}, 1}));
  EXPECT_EQ(refinement.samples(), had);
  refine(refinement, had + 1);
  EXPECT_GT(refinement.spent_s(), 0);
}

// A pass that takes long is shown part by part, around them what there was before; in the end it is as any other.
TEST_F(RefinementTest, ALongPassComesInParts) {
  constexpr int kWide = 300, kHigh = 200;
  constexpr double kSlow_s = 1e-3;  // a path, as expected: a minute for the picture
  Refinement whole(cloth, kWide, kHigh, {.secondsPerPath = kSlow_s});
  whole.beginWith({2, 1e9});
  ASSERT_TRUE(whole.advance(Task{{}, {}, 1}));
  const Frame coarse = whole.frame();
  ASSERT_EQ(coarse.divider, 2);

  std::stop_source stop;
  Traceable watched = cloth;
  watched.medium = std::make_shared<const test::WatchedMedium>(cloth.medium, [&](uint64_t path) {
    if (path == kWide * kHigh / 3) stop.request_stop();
  });
  Refinement inParts(watched, kWide, kHigh, {.secondsPerPath = kSlow_s});
  inParts.standIn(std::make_shared<const Frame>(coarse));
  inParts.skipCoarse(2);
  EXPECT_TRUE(inParts.begun());
  EXPECT_EQ(inParts.frame().hits[0].yarn, coarse.hits[0].yarn) << "before it has a pixel of its own";
  while (inParts.advance(Task{stop.get_token(), {}, 1})) ASSERT_EQ(inParts.samples(), 0u);
  EXPECT_EQ(inParts.film().samples(kWide / 2, kHigh / 2), 1u) << "the middle first";
  EXPECT_EQ(inParts.film().samples(0, 0), 0u) << "the corners last";
  const Frame frame = inParts.frame();
  EXPECT_EQ(frame.divider, 1);
  EXPECT_EQ(frame.samples, 0);
  EXPECT_EQ(frame.hits[0].yarn, coarse.hits[0].yarn) << "as before";

  refine(inParts, 2);
  Film straight(kWide, kHigh);
  renderUpTo(inParts.samples(), *cloth.scene, *watched.medium, CameraRays(cloth.scene->fabric->camera, kWide, kHigh),
             straight, Task{});
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) ASSERT_EQ(inParts.film().mean(x, y), straight.mean(x, y));
}

TEST_F(RefinementTest, AYoungPictureIsHelpedForTheDisplayAlone) {
  constexpr uint32_t kClear = 16;  // from there on pictures are shown as they are
  Refinement refinement(cloth, kWidth, kHeight, {.secondsPerPath = 1e-3});
  while (refinement.samples() < kClear) {
    ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
    if (refinement.samples() == 0) continue;
    const Frame frame = refinement.frame();
    EXPECT_EQ(frame.helped.empty(), refinement.samples() >= kClear);
    EXPECT_NE(frame.helped, frame.rgba);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        ASSERT_EQ(Rgb(frame.rgba[static_cast<size_t>(y) * kWidth + x]), refinement.film().mean(x, y));
  }
}

TEST_F(RefinementTest, WhatStandsInIsHelpedForTheDisplayAlone) {
  const glm::vec4 traced(0.5f, 0.5f, 0.5f, 1), helped(0.25f, 0.75f, 0.5f, 1);
  Frame earlier;
  earlier.width = kWidth;
  earlier.height = kHeight;
  earlier.window = {0, 0, kWidth, kHeight};
  earlier.samples = 8;
  earlier.rgba.assign(size_t{kWidth} * kHeight, traced);
  earlier.helped.assign(earlier.rgba.size(), helped);
  earlier.hits.resize(earlier.rgba.size());
  Refinement refinement(cloth, kWidth, kHeight, {});
  refinement.standIn(std::make_shared<const Frame>(earlier));
  refinement.skipCoarse();
  const Frame frame = refinement.frame();
  EXPECT_EQ(frame.rgba, earlier.rgba);
  ASSERT_EQ(frame.helped.size(), earlier.helped.size());
  for (const glm::vec4& pixel : frame.helped) EXPECT_LT(glm::distance(pixel, helped), 1e-5f);
}

TEST_F(RefinementTest, TakesOverFromAnotherPictureWithoutALeapAndForgetsIt) {
  constexpr uint32_t kClear = 16;  // from there on pictures are shown as they are
  Refinement refinement(cloth, kWidth, kHeight, {});
  Frame earlier;
  earlier.width = kWidth;
  earlier.height = kHeight;
  earlier.window = {0, 0, kWidth, kHeight};
  earlier.samples = 8;
  earlier.rgba.assign(size_t{kWidth} * kHeight, glm::vec4(0.2f, 0.2f, 0.2f, 1));  // darker than the cloth by far
  earlier.hits.resize(earlier.rgba.size());
  refinement.standIn(std::make_shared<const Frame>(earlier));
  refinement.skipCoarse();
  EXPECT_TRUE(refinement.fading());
  EXPECT_EQ(refinement.frame().rgba, earlier.rgba) << "nothing is seen of a picture without samples";
  EXPECT_EQ(refinement.frame().samples, earlier.samples);

  // Every step is a small one, whatever the machine's speed.
  const auto brightness = [](const Frame& frame) {
    double sum = 0;
    for (const glm::vec4& pixel : frame.shown()) sum += pixel.g;
    return sum / static_cast<double>(frame.shown().size());
  };
  std::vector<double> seen{brightness(refinement.frame())};
  while (refinement.fading()) {
    ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
    seen.push_back(brightness(refinement.frame()));
  }
  const double leap = std::abs(seen.back() - seen.front());
  ASSERT_GT(leap, 0.05);
  for (size_t i = 1; i < seen.size(); ++i) EXPECT_LT(std::abs(seen[i] - seen[i - 1]), 0.3 * leap) << i;

  refine(refinement, kClear);
  EXPECT_FALSE(refinement.fading());
  const Frame last = refinement.frame();
  EXPECT_EQ(last.samples, static_cast<int>(refinement.samples()));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      ASSERT_EQ(Rgb(last.rgba[static_cast<size_t>(y) * kWidth + x]), refinement.film().mean(x, y));
}

}  // namespace
}  // namespace loomlight
