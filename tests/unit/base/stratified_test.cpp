#include "core/base/stratified.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/base/random.h"

namespace loomlight {
namespace {

TEST(Stratified, BitsReverse) {
  static_assert(stratified::reverseBits(1) == 0x80000000u);
  static_assert(stratified::reverseBits(0x12345678u) == 0x1E6A2C48u);
  for (uint32_t x = 1; x < 1000000; x = 3 * x + 1) EXPECT_EQ(stratified::reverseBits(stratified::reverseBits(x)), x);
}

// Sobol's recurrence for the second dimension: v(k + 1) = v(k) ^ (v(k) >> 1).
TEST(Stratified, PascalIsSobolsSecondDimension) {
  for (uint32_t index = 0; index < 4096; ++index) {
    uint32_t direction = 0x80000000u, expected = 0;
    for (uint32_t bits = index * 1048573u; bits != 0; bits >>= 1, direction ^= direction >> 1)
      if (bits & 1) expected ^= direction;
    EXPECT_EQ(stratified::reverseBits(stratified::pascal(index * 1048573u)), expected);
  }
}

// A scrambled (0,2)-sequence: any aligned 2^k points have one in each elementary interval of area 2^-k.
TEST(Stratified, EveryElementaryIntervalHoldsOnePoint) {
  for (const uint64_t seed : {1u, 77u, 123456u})
    for (const uint32_t pair : {0u, 6u})
      for (int k = 0; k <= 8; ++k)
        for (int across = 0; across <= k; ++across)
          for (const uint32_t block : {0u, 5u}) {
            std::set<uint64_t> cells;
            for (uint32_t i = 0; i < 1u << k; ++i) {
              const uint32_t index = (block << k) + i;
              const uint64_t x = stratified::coordinate(seed, index, pair);
              const uint64_t y = stratified::coordinate(seed, index, pair + 1);
              cells.insert((x << across >> 32 << (k - across)) | (y << (k - across) >> 32));
            }
            EXPECT_EQ(cells.size(), size_t{1} << k);
          }
}

// A point of its own is uniform over seeds, whatever its index: estimates are unbiased.
TEST(Stratified, EachPointIsUniform) {
  constexpr int kSeeds = 20000, kCells = 16;
  for (const uint32_t index : {0u, 1u, 6u, 1000u})
    for (const uint32_t dimension : {0u, 1u, 7u}) {
      std::vector<int> counts(kCells);
      for (uint64_t seed = 0; seed < kSeeds; ++seed)
        ++counts[stratified::coordinate(mixBits(seed), index, dimension) >> 28];
      constexpr double kExpected = 1.0 * kSeeds / kCells;
      double chiSquare = 0;
      for (const int count : counts) chiSquare += std::pow(count - kExpected, 2) / kExpected;
      EXPECT_LT(chiSquare, 50);  // 15 degrees of freedom: one in 10^5
    }
}

// Two numbers that are drawn at once are two dimensions that are stratified together, and none of the next purpose.
TEST(Stratified, APairOfNumbersIsAPairOfDimensions) {
  constexpr uint64_t kSeed = 9;
  const auto number = [](uint32_t index, uint32_t dimension) {
    return static_cast<float>(stratified::coordinate(kSeed, index, dimension) >> 8) * 0x1p-24f;
  };
  for (uint32_t index = 0; index < 100; ++index) {
    Random random(kSeed, index);
    random.stratify(4, 7);
    EXPECT_EQ(random.uniform(), number(index, 4));
    for (const uint32_t dimension : {6u, 8u}) {
      const Random::Pair pair = random.uniformPair();
      EXPECT_EQ(pair.first, number(index, dimension));
      EXPECT_EQ(pair.second, number(index, dimension + 1));
    }
    EXPECT_NE(random.uniformPair().first, number(index, 10));  // 11 belongs to whoever comes next
    EXPECT_NE(random.uniform(), number(index, 10));
  }
}

// Different pairs of dimensions know nothing of each other.
TEST(Stratified, PairsAreIndependent) {
  constexpr int kSeeds = 200, kPoints = 64;
  double product = 0;
  for (uint64_t seed = 0; seed < kSeeds; ++seed)
    for (uint32_t i = 0; i < kPoints; ++i)
      product += (stratified::coordinate(mixBits(seed), i, 0) * 0x1p-32 - 0.5) *
                 (stratified::coordinate(mixBits(seed), i, 2) * 0x1p-32 - 0.5) * 12;
  EXPECT_LT(std::abs(product) / std::sqrt(double{kSeeds} * kPoints), 4);
}

// The error of a smooth integral falls much faster than that of random numbers: Owen 1997.
TEST(Stratified, IntegratesBetterThanChance) {
  constexpr uint32_t kPoints = 256;
  double squares = 0;
  for (uint64_t seed = 0; seed < 50; ++seed) {
    double sum = 0;
    for (uint32_t i = 0; i < kPoints; ++i) {
      Random random(mixBits(seed), i);
      random.stratify(4, 2);
      sum += static_cast<double>(random.uniform()) * random.uniform();
    }
    squares += std::pow(sum / kPoints - 0.25, 2) / 50;
  }
  const double byChance = (1.0 / 9 - 1.0 / 16) / kPoints;
  EXPECT_LT(squares, byChance / 50);
}

TEST(Random, IsRandomBeyondWhatIsStratified) {
  Random a(5, 3), b(5, 3), other(5, 4);
  a.stratify(0, 2);
  EXPECT_NE(a.uniform(), b.uniform());
  a.uniform();
  Random c(5, 3);
  EXPECT_EQ(a.uniform(), c.uniform());
  EXPECT_NE(c.uniform(), other.uniform());
}

}  // namespace
}  // namespace loomlight
