#include "render/film/film.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/base/random.h"
#include "tests/unit/film/film_samples.h"

namespace loomlight {
namespace {

using test::addAll;
using test::expectSameSums;
using test::randomSample;

constexpr int kFilmWidth = 5, kFilmHeight = 3;
constexpr uint32_t kSamples = 60;

TEST(Film, OrderOfSamplesDoesNotMatter) {
  std::vector<uint32_t> order(kSamples);
  std::iota(order.begin(), order.end(), 0u);
  Film forwards(kFilmWidth, kFilmHeight);
  addAll(forwards, order);
  Random random(7);
  for (int trial = 0; trial < 5; ++trial) {
    for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(static_cast<uint32_t>(i))]);
    Film shuffled(kFilmWidth, kFilmHeight);
    addAll(shuffled, order);
    expectSameSums(forwards, shuffled);
  }
}

TEST(Film, SplitSamplesMergeToTheSameSums) {
  std::vector<uint32_t> all(kSamples);
  std::iota(all.begin(), all.end(), 0u);
  Film whole(kFilmWidth, kFilmHeight);
  addAll(whole, all);
  // Dealt to three films at random, merged in both orders.
  std::vector<uint32_t> parts[3];
  Random random(11);
  for (const uint32_t i : all) parts[random.below(3)].push_back(i);
  for (const bool backwards : {false, true}) {
    Film merged(kFilmWidth, kFilmHeight);
    for (int k = 0; k < 3; ++k) {
      Film part(kFilmWidth, kFilmHeight);
      addAll(part, parts[backwards ? 2 - k : k]);
      merged.merge(part);
    }
    expectSameSums(whole, merged);
  }
}

TEST(Film, MeanIsExactToHalfAQuantum) {
  Film film(1, 1);
  Random random(3);
  glm::dvec3 sum(0);
  constexpr uint32_t n = 1000;
  for (uint32_t i = 0; i < n; ++i) {
    const PathSample s = randomSample(random);
    sum += glm::dvec3(s.direct) + glm::dvec3(s.indirect);
    film.add(0, 0, i, s);
  }
  for (int c = 0; c < 3; ++c) {
    const double mean = sum[c] / n;
    // Two roundings to 2^-24 a sample, half a quantum each at most; then one to float.
    EXPECT_NEAR(film.mean(0, 0)[c], mean, 0x1p-24 + mean * 0x1p-24);
  }
}

TEST(Film, VarianceIsThatOfTheMeanOfTheSamples) {
  Film film(1, 1);
  Random random(5);
  std::vector<double> values;
  for (uint32_t i = 0; i < 500; ++i) {
    const float y = 3 * random.uniform();
    values.push_back(y);
    PathSample s;
    s.direct = Rgb(0.25f * y);
    s.indirect = Rgb(0.75f * y);
    film.add(0, 0, i, s);
  }
  const double n = static_cast<double>(values.size()), mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double expected = squares / (n - 1) / n;
  EXPECT_NEAR(film.variance(0, 0), expected, 1e-6 * expected);
  // Uniform on [0, 3]: 9/12 over n; the sample variance itself is known to sqrt(0.8 / n), here 4 %.
  EXPECT_NEAR(film.variance(0, 0), 0.75 / n, 0.16 * 0.75 / n);
}

TEST(Film, ConstantLightHasNoVariance) {
  Film film(1, 1);
  PathSample s;
  s.direct = Rgb(0.3f, 0.7f, 0.1f);
  for (uint32_t i = 0; i < 1000; ++i) film.add(0, 0, i, s);
  EXPECT_LT(film.variance(0, 0), 1e-11f);
}

TEST(Film, PixelsWithoutSamplesAreZero) {
  const Film film(2, 2);
  EXPECT_EQ(film.mean(1, 1), Rgb(0));
  EXPECT_EQ(film.alpha(1, 1), 0);
  EXPECT_EQ(film.variance(1, 1), 0);
  EXPECT_EQ(film.hit(1, 1).yarn, -1);
  for (const Image::Channel& channel : film.toImage(true).channels) {
    const bool isId = channel.name == "yarn.id" || channel.name.starts_with("crossing.");
    EXPECT_THAT(channel.values, testing::Each(isId ? -1.0f : 0.0f)) << channel.name;
  }
}

TEST(Film, PartsMergeWhereTheyLie) {
  Film whole(5, 4), parts(5, 4);
  addAll(whole, {0, 1, 2, 3});
  Film few(5, 4), more(5, 4);
  addAll(few, {2, 3});
  addAll(more, {0, 1});
  for (const Film* samples : {&few, &more})
    for (const PixelRect& window : {PixelRect{0, 0, 2, 4}, PixelRect{2, 0, 3, 1}, PixelRect{2, 1, 3, 3}}) {
      const Film part = samples->cropped(window);
      EXPECT_EQ(part.width(), window.width);
      EXPECT_EQ(part.mean(0, 0), samples->mean(window.x, window.y));
      parts.merge(part, window.x, window.y);
    }
  expectSameSums(whole, parts);
}

TEST(Film, GeometryIsTheMeanOverSamplesThatMetAFibre) {
  Film film(1, 1);
  PathSample hit;
  hit.alpha = 1;
  hit.depth_mm = 40;
  hit.normal = {0, 0.6f, 0.8f};
  hit.tangent = {-1, 0, 0};
  film.add(0, 0, 0, hit);
  hit.depth_mm = 50;
  film.add(0, 0, 1, hit);
  PathSample miss;
  miss.depth_mm = 1e6f;  // of no meaning, and ignored
  for (uint32_t i = 2; i < 8; ++i) film.add(0, 0, i, miss);
  const Image image = film.toImage(false);
  EXPECT_EQ(film.alpha(0, 0), 0.25f);
  EXPECT_EQ(image.find("A")->values[0], 0.25f);
  EXPECT_EQ(image.find("depth.Z")->values[0], 45.0f);
  EXPECT_NEAR(image.find("normal.Y")->values[0], 0.6f, 0x1p-11);
  EXPECT_NEAR(image.find("normal.Z")->values[0], 0.8f, 0x1p-11);
  EXPECT_EQ(image.find("tangent.X")->values[0], -1.0f);
}

TEST(Film, HitIsThatOfTheLowestNumberedSampleThatMetAFibre) {
  Film film(1, 1);
  const auto add = [&](uint32_t index, float alpha, int yarn) {
    PathSample s;
    s.alpha = alpha;
    s.yarn = yarn;
    s.end = 10 * yarn;
    s.pick = 100 * yarn;
    s.depth_mm = static_cast<float>(yarn);
    film.add(0, 0, index, s);
  };
  add(9, 1, 3);
  EXPECT_EQ(film.hit(0, 0).yarn, 3);
  add(4, 1, 5);
  add(2, 0, 7);
  add(6, 1, 2);
  const Film::Hit hit = film.hit(0, 0);
  EXPECT_EQ(hit.yarn, 5);
  EXPECT_EQ(hit.end, 50);
  EXPECT_EQ(hit.pick, 500);
  EXPECT_EQ(hit.depth_mm, 5.0f);
}

TEST(Film, RefusesWhatIsNoRadiance) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  Film film(1, 1);
  PathSample s;
  s.alpha = 1;
  s.direct = {nan, -1, infinity};
  s.normal = {nan, infinity, -infinity};
  film.add(0, 0, 0, s);
  EXPECT_EQ(film.mean(0, 0), Rgb(0, -1, 0x1p18f)) << "colours outside of the gamut are colours";
  const Image image = film.toImage(true);
  for (const Image::Channel& channel : image.channels)
    for (const float v : channel.values) EXPECT_TRUE(std::isfinite(v)) << channel.name;
  EXPECT_EQ(image.find("normal.X")->values[0], 0);
  EXPECT_EQ(image.find("normal.Y")->values[0], 1);
  EXPECT_EQ(image.find("normal.Z")->values[0], -1);
}

TEST(Film, BrightestSamplesSaturateWithoutLosingTheirSums) {
  PathSample s;
  s.direct = s.indirect = Rgb(1e30f);
  Film film(1, 1), half(1, 1);
  for (uint32_t i = 0; i < Film::maxSamples; ++i) (i % 2 ? film : half).add(0, 0, i, s);
  film.merge(half);
  EXPECT_EQ(film.samples(0, 0), Film::maxSamples);
  EXPECT_EQ(film.mean(0, 0), Rgb(0x1p19f));  // 2^18 direct and as much indirect
  EXPECT_EQ(film.variance(0, 0), std::numeric_limits<float>::infinity());
  Film one(1, 1);
  one.add(0, 0, 0, s);
  EXPECT_THROW(film.merge(one), InputError);
  EXPECT_EQ(film.samples(0, 0), Film::maxSamples);
}

TEST(Film, DisplayBufferIsMeanAndAlpha) {
  Film film(kFilmWidth, kFilmHeight);
  addAll(film, {0, 1, 2});
  std::vector<glm::vec4> rgba(1);
  film.toDisplayBuffer(rgba);
  ASSERT_EQ(rgba.size(), static_cast<size_t>(kFilmWidth * kFilmHeight));
  for (int y = 0; y < kFilmHeight; ++y)
    for (int x = 0; x < kFilmWidth; ++x)
      EXPECT_EQ(rgba[static_cast<size_t>(y * kFilmWidth + x)], glm::vec4(film.mean(x, y), film.alpha(x, y)));
}

TEST(Film, RefusesImpossibleSizes) {
  EXPECT_THROW(Film(0, 1), InputError);
  EXPECT_THROW(Film(1, -1), InputError);
  EXPECT_THROW(Film(16385, 1), InputError);
}

}  // namespace
}  // namespace loomlight
