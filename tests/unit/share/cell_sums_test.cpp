#include "render/share/cell_sums.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace loomlight {
namespace {

/// A cell `b` of cell `a`; each level but these has one cell in the one before.
LightCellPath path(uint64_t a, uint64_t b = 0) {
  LightCellPath path;
  uint64_t key = 1;
  for (uint64_t level = 0; level < kLightCellLevels; ++level) {
    if (level == 1) key = hashCombine(key, a);
    if (level == 2) key = hashCombine(key, b);
    key = mixBits(key);
    path.keys[level] = (key & ~kLightCellLevelMask) | level;
  }
  return path;
}

// Single paths may be of colours outside of the gamut whose mean is not: to cut them off would bleach it.
TEST(CellSums, NegativeChannelsCount) {
  CellSums sums;
  const uint32_t cell = sums.add(path(1));
  sums.deposit(cell, Rgb(-1, 2, 0));
  sums.deposit(cell, Rgb(3, 0, 1));
  EXPECT_EQ(sums[cell].sum(), glm::dvec3(2, 2, 1));
  EXPECT_EQ(sums[cell].sumOfSquares(), 1 + 4 + 9 + 1);
}

TEST(CellSums, ADepositIsInEveryCellAbove) {
  CellSums sums;
  const uint32_t first = sums.add(path(1)), second = sums.add(path(2));
  EXPECT_EQ(sums.add(path(1)), first);
  EXPECT_NE(first, second);
  sums.deposit(first, Rgb(1, 2, 3));
  sums.deposit(second, Rgb(0.5f));
  EXPECT_EQ(sums[first].paths, 1u);
  EXPECT_EQ(sums[first].sum(), glm::dvec3(1, 2, 3));
  EXPECT_EQ(sums[0].paths, 2u);
  EXPECT_EQ(sums[0].sum(), glm::dvec3(1.5, 2.5, 3.5));
  EXPECT_EQ(sums[0].sumOfSquares(), 1 + 4 + 9 + 0.75);
}

TEST(CellSums, TheNearestIsTheFinestThatIsKnown) {
  CellSums sums;
  EXPECT_FALSE(sums.nearest(path(1)));
  const uint32_t cell = sums.add(path(1, 2));
  EXPECT_EQ(sums.nearest(path(1, 2)), cell);
  EXPECT_EQ(sums.nearest(path(1, 3)), sums[sums[sums[cell].parent].parent].parent);
  EXPECT_EQ(sums.nearest(path(9, 2)), 0u);
}

TEST(CellSums, NeverTakesMoreThanItsLimitAndLosesNoLight) {
  EXPECT_LE(CellSums().bytes(), CellSums::kLimit_bytes);
  for (const size_t limit : {size_t{1} << 14, size_t{100'000}}) {
    CellSums sums(limit);
    EXPECT_LE(sums.bytes(), limit);
    constexpr uint32_t kPaths = 20'000;
    for (uint32_t i = 0; i < kPaths; ++i) sums.deposit(sums.add(path(i % 7, i)), Rgb(1));
    EXPECT_EQ(sums.size(), sums.roomFor(2)) << "each path has a cell of its own at that level";
    EXPECT_LE(sums.size() * (sizeof(CellSums::Cell) + sizeof(CellMeans::Mean)), limit);
    EXPECT_EQ(sums[0].paths, kPaths);
    EXPECT_EQ(sums[0].sum(), glm::dvec3(kPaths));
    EXPECT_EQ(sums[sums.add(path(100))].level(), 1) << "a way to lie that is new has room all the same";
    EXPECT_LT(sums.roomFor(1), sums.roomFor(0));
  }
}

TEST(CellSums, FadedCellsKeepTheirColourAndCountForLess) {
  CellSums sums;
  const uint32_t cell = sums.add(path(1)), rare = sums.add(path(2));
  for (int i = 0; i < 90; ++i) sums.deposit(cell, Rgb(0.25f, 0.5f, 1));
  for (int i = 0; i < 10; ++i) sums.deposit(rare, Rgb(2));
  sums.fade(200);
  EXPECT_EQ(sums[cell].paths, 90u);
  sums.fade(16);  // 32 paths in two cells
  EXPECT_EQ(sums[0].paths, 32u);
  EXPECT_EQ(sums[cell].paths, 29u);
  EXPECT_EQ(sums[rare].paths, 3u);
  EXPECT_NEAR(sums[cell].sum().g / 29, 0.5, 1e-6);
  sums.fade(0);
  EXPECT_EQ(sums[cell].paths, 0u);
  EXPECT_EQ(sums[cell].sum(), glm::dvec3(0));
}

/// Cells whose own light spreads by `between`, of paths that spread by `noise`, under a lamp of that intensity.
CellSums spreadCells(float between, float noise, int cells, int paths, float intensity = 1) {
  CellSums sums;
  Random random(7);
  const auto either = [&](float size) { return random.below(2) == 0 ? size : -size; };
  for (int i = 0; i < cells; ++i) {
    const uint32_t cell = sums.add(path(0, static_cast<uint64_t>(i)));
    const float own = 2 + either(between);
    for (int k = 0; k < paths; ++k) sums.deposit(cell, Rgb(intensity * (own + either(noise))));
  }
  return sums;
}

TEST(CellSums, OfManyTheBusiestStayAndNoLightIsLost) {
  CellSums sums;
  const auto deposit = [&sums](const LightCellPath& path, int times) {
    for (int i = 0; i < times; ++i) sums.deposit(sums.add(path), Rgb(1, 2, 3));
  };
  deposit(path(1, 2), 2);
  deposit(path(1, 3), 5);
  deposit(path(2, 1), 9);
  const size_t all = sums.size();
  sums.keep(all);
  EXPECT_EQ(sums.size(), all);
  sums.keep(all - 1);
  EXPECT_EQ(sums.size(), all - (kLightCellLevels - 2)) << "of the first all but what it shares with the second";
  EXPECT_FALSE(sums.find(path(1, 2)));
  const auto second = sums.find(path(1, 3)), third = sums.find(path(2, 1)), above = sums.nearest(path(1, 2));
  ASSERT_TRUE(second && third && above);
  EXPECT_EQ(sums[*second].paths, 5u);
  EXPECT_EQ(sums[*third].paths, 9u);
  EXPECT_EQ(sums[*above].paths, 7u);
  EXPECT_EQ(sums[*above].sum(), glm::dvec3(7, 14, 21));
  deposit(path(1, 2), 1);
  deposit(path(2, 1), 1);
  EXPECT_EQ(sums[*above].paths, 8u);
  EXPECT_EQ(sums[*sums.find(path(1, 2))].paths, 1u);
  EXPECT_EQ(sums[*sums.nearest(path(2, 7))].paths, 10u);
  EXPECT_EQ(sums[0].paths, 18u);
  sums.keep(0);
  EXPECT_EQ(sums.size(), 0u);
  EXPECT_FALSE(sums.nearest(path(1, 2)));
}

TEST(CellMeans, AParentIsWorthTheNoiseOverTheSpread) {
  // 400 cells of 20 paths: the variance between cells has a standard error of 7 %, that within one of 2 %.
  const CellMeans means(spreadCells(0.5f, 1.0f, 400, 20));
  EXPECT_NEAR(means.parentWorth_paths(2), 4, 4 * 3 * 0.08);
}

// Black cloth in the dusk, and white in the sun: what is alike is so however bright it is.
TEST(CellMeans, WhatAParentIsWorthDoesNotDependOnHowBrightTheLightIs) {
  const double worth = CellMeans(spreadCells(0.5f, 1.0f, 400, 20)).parentWorth_paths(2);
  for (const float intensity : {0.001f, 1000.0f}) {
    // Colours are rounded to 2^-20: in the dusk, a thousandth of the noise.
    const double other = CellMeans(spreadCells(0.5f, 1.0f, 400, 20, intensity)).parentWorth_paths(2);
    EXPECT_NEAR(other, worth, 0.005 * worth) << intensity;
  }
}

TEST(CellSums, SquaresOfBrightLightAddUpBeyondAnyWord) {
  CellSums sums;
  const uint32_t cell = sums.add(path(1));
  constexpr int kPaths = 1 << 10;
  for (int i = 0; i < kPaths; ++i) sums.deposit(cell, Rgb(0x1p16f, 0, 0));  // each 2^60 quanta
  EXPECT_EQ(sums[cell].sumOfSquares(), kPaths * 0x1p32);
  sums.fade(kPaths / 4);
  EXPECT_EQ(sums[cell].paths, kPaths / 4u);
  EXPECT_EQ(sums[cell].sumOfSquares(), 0.25 * kPaths * 0x1p32);
}

// Beside white yarns on both sides of the cloth, all alike and well known, the first few paths from a red one.
TEST(CellMeans, AYarnThatIsNewHasItsOwnColour) {
  CellSums sums;
  for (uint64_t yarn = 0; yarn < 4; ++yarn) {
    const uint32_t white = sums.add(path(yarn));
    for (int i = 0; i < 10'000; ++i) sums.deposit(white, Rgb(i % 2 == 0 ? 0.5f : 1.5f));
  }
  const uint32_t red = sums.add(path(9));
  for (int i = 0; i < 80; ++i) sums.deposit(red, Rgb(1, 0, 0));
  EXPECT_LT(CellMeans(sums)[red].colour.g, 0.1);
}

TEST(CellMeans, AlikeCellsAreOne) {
  const CellSums sums = spreadCells(0, 1, 400, 4);
  const CellMeans means(sums);
  double square = 0;
  for (uint64_t i = 0; i < 400; ++i) {
    const double off = means[*sums.find(path(0, i))].colour.r - 2;
    square += off * off / 400;
  }
  EXPECT_LT(square, 0.1 * (1.0 / 4));  // a tenth of the variance of cells on their own
}

TEST(CellMeans, ManyPathsSpeakForThemselves) {
  CellSums sums = spreadCells(0.5f, 1.0f, 100, 20);
  const uint32_t cell = sums.add(path(0, 1000));
  for (int i = 0; i < 100'000; ++i) sums.deposit(cell, Rgb(5, 0, 1));
  const CellMeans means(sums);
  EXPECT_NEAR(means[cell].colour.r, 5, 0.01);
  EXPECT_NEAR(means[cell].colour.g, 0, 0.01);
  EXPECT_NEAR(means[cell].square, 26, 0.1);
}

}  // namespace
}  // namespace loomlight
