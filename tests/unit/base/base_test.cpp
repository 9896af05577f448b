#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/task.h"

namespace loomlight {
namespace {

TEST(Hash, MixBitsMovesHalfOfTheBits) {
  // Every input bit flips each of 64 output bits with probability 1/2: over 64 x 200 flips the mean is 32 +- 0.035.
  double flipped = 0;
  for (uint64_t x = 0; x < 200; ++x)
    for (int bit = 0; bit < 64; ++bit)
      flipped += std::popcount(mixBits(x * 0x9E3779B97F4A7C15ull) ^ mixBits(x * 0x9E3779B97F4A7C15ull ^ 1ull << bit));
  EXPECT_NEAR(flipped / (200 * 64), 32.0, 5 * 4.0 / std::sqrt(200.0 * 64.0));
}

TEST(Hash, OrderAndValueMatter) {
  const uint64_t start = 1;
  EXPECT_NE(hashCombine(hashCombine(start, 1), 2), hashCombine(hashCombine(start, 2), 1));
  EXPECT_NE(hashCombine(start, 0.0f), hashCombine(start, -0.0f)) << "bit for bit";
  EXPECT_EQ(hashCombine(start, 1.5), hashCombine(start, 1.5));
  std::set<uint64_t> seen;
  for (int i = 0; i < 100000; ++i) seen.insert(hashCombine(start, i));
  EXPECT_EQ(seen.size(), 100000u);
}

TEST(Random, IsAFunctionOfItsSeed) {
  Random a(7), b(7), c(8);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.next(), b.next());
  EXPECT_NE(a.next(), c.next());
}

TEST(Random, UniformHasTheMomentsOfUniform) {
  constexpr int n = 200000;
  Random random(1);
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const float u = random.uniform();
    ASSERT_GE(u, 0.0f);
    ASSERT_LT(u, 1.0f);
    sum += u;
    squares += static_cast<double>(u) * u;
  }
  // Five standard errors: 1/sqrt(12 n), and sqrt(4/45 / n) for the squares.
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1 / 12.0 / n));
  EXPECT_NEAR(squares / n, 1.0 / 3.0, 5 * std::sqrt(4 / 45.0 / n));
}

TEST(Random, BelowIsEvenAndInRange) {
  constexpr int n = 60000, kinds = 6;
  Random random(2);
  int counts[kinds] = {};
  for (int i = 0; i < n; ++i) {
    const uint32_t k = random.below(kinds);
    ASSERT_LT(k, static_cast<uint32_t>(kinds));
    ++counts[k];
  }
  double chi2 = 0;
  for (const int count : counts) chi2 += std::pow(count - n / kinds, 2) / (static_cast<double>(n) / kinds);
  EXPECT_LT(chi2, 20.5) << "chi-square with 5 degrees of freedom, p = 0.001";
}

TEST(Random, NeighbouringSeedsAreIndependent) {
  // Correlation of first numbers of seeds i and i + 1; standard error 1 / sqrt(n).
  constexpr int n = 20000;
  double product = 0;
  for (int i = 0; i < n; ++i)
    product += (Random(static_cast<uint64_t>(i)).uniformDouble() - 0.5) *
               (Random(static_cast<uint64_t>(i) + 1).uniformDouble() - 0.5) * 12;
  EXPECT_NEAR(product / n, 0.0, 5 / std::sqrt(static_cast<double>(n)));
}

TEST(Parallel, EveryIndexOnce) {
  for (const int threads : {0, 1, 2, 3, 7}) {
    std::vector<std::atomic<int>> met(1000);
    parallelFor(met.size(), threads, [&](size_t i) { ++met[i]; });
    for (const auto& count : met) EXPECT_EQ(count, 1);
  }
  parallelFor(0, 2, [](size_t) { FAIL(); });
}

TEST(Parallel, ExceptionsReachTheCaller) {
  for (const int threads : {1, 2})
    EXPECT_THROW(parallelFor(100, threads,
                             [](size_t i) {
                               if (i == 57) throw std::runtime_error("57");
                             }),
                 std::runtime_error);
}

TEST(Parallel, NestsWithoutDeadlock) {
  std::atomic<int> count = 0;
  parallelFor(8, 2, [&](size_t) { parallelFor(8, 2, [&](size_t) { ++count; }); });
  EXPECT_EQ(count, 64);
}

TEST(Parallel, WithThreadsCallsOnceAndLetsExceptionsThrough) {
  for (const int threads : {0, 1, 2}) {
    int calls = 0;
    withThreads(threads, [&] { ++calls; });
    EXPECT_EQ(calls, 1);
    EXPECT_THROW(withThreads(threads, [] { throw std::runtime_error("threads"); }), std::runtime_error);
  }
}

TEST(Task, StopsAndReports) {
  std::stop_source source;
  double reported = -1;
  const Task task{source.get_token(), [&](double fraction) { reported = fraction; }, 1};
  EXPECT_FALSE(task.stopped());
  task.report(0.5);
  EXPECT_EQ(reported, 0.5);
  source.request_stop();
  EXPECT_TRUE(task.stopped());
  Task{}.report(1.0);
}

}  // namespace
}  // namespace loomlight
