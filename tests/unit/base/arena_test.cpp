#include "core/base/arena.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <vector>

#include "core/base/modulo.h"
#include "core/base/random.h"

namespace loomlight {
namespace {

struct Range {
  uint32_t first, count;
  int value;
};

TEST(Arena, RangesKeepTheirPlaceAndTheirValues) {
  Arena<int> arena(1 << 22);
  const int* const data = arena.data();
  std::vector<Range> taken;
  Random random(3);
  uint32_t used = 0, mostUsed = 0, farthest = 0;
  for (int step = 0; step < 20000; ++step) {
    if (taken.empty() || random.below(100) < (step < 10000 ? 60u : 40u)) {
      const uint32_t count = 1 + random.below(500);
      const Range range{arena.take(count), count, step};
      std::fill_n(arena.data() + range.first, count, step);
      taken.push_back(range);
      used += count;
      mostUsed = std::max(mostUsed, used);
      farthest = std::max(farthest, range.first + count);
    } else {
      std::swap(taken[random.below(static_cast<uint32_t>(taken.size()))], taken.back());
      const Range range = taken.back();
      taken.pop_back();
      ASSERT_TRUE(std::all_of(data + range.first, data + range.first + range.count, [&](int value) {
        return value == range.value;
      })) << "nobody else had it";
      arena.giveBack(range.first, range.count);
      used -= range.count;
    }
    ASSERT_EQ(arena.data(), data);
  }
  EXPECT_LT(farthest, mostUsed + mostUsed / 2) << "what was given back is taken again";
  for (const Range& range : taken) arena.giveBack(range.first, range.count);
  EXPECT_EQ(arena.take(mostUsed), 0u) << "all of it is one range again";
}

TEST(Arena, TakesNoMoreThanThereIs) {
  Arena<double> arena(1 << 20);
  const uint32_t first = arena.take(1 << 19);
  EXPECT_THROW(arena.take((1 << 20) + 1), std::bad_alloc);
  EXPECT_THROW(arena.take(0xFFFFFFFF), std::bad_alloc);
  EXPECT_EQ(arena.take(0), 0u);
  arena.giveBack(0, 0);
  arena.data()[first] = 1;
  EXPECT_EQ(arena.take(1 << 19), uint32_t{1} << 19) << "as if nothing had been asked for";
}

TEST(Modulo, IsTheRemainder) {
  Random random(5);
  for (int i = 0; i < 200000; ++i) {
    const auto divisor = static_cast<uint32_t>(random.next() >> (32 + random.below(32))) | 1u << random.below(31);
    const auto n = static_cast<uint32_t>(random.next() >> (32 + random.below(32)));
    ASSERT_EQ(Modulo(divisor)(n), n % divisor) << n << " by " << divisor;
  }
  for (const uint32_t divisor : {1u, 2u, 3u, 0x80000000u, 0xFFFFFFFFu})
    for (const uint32_t n : {0u, 1u, divisor - 1, divisor, 0xFFFFFFFFu}) EXPECT_EQ(Modulo(divisor)(n), n % divisor);
  EXPECT_EQ(Modulo()(77), 0u);
}

}  // namespace
}  // namespace loomlight
