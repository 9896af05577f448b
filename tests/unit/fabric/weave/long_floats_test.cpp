#include "core/fabric/yarn/long_floats.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/structures.h"
#include "core/fabric/yarn/derived.h"

namespace loomlight {
namespace {

/// Of 20 ends and 40 picks to the cm: a weft float is twice as long as a warp float of as many crossings.
Fabric clothOf(Weave weave) {
  Fabric fabric;
  fabric.weave = std::move(weave);
  fabric.ends_per_cm = 20;
  fabric.picks_per_cm = 40;
  return fabric;
}

bool marksAnything(const Fabric& fabric, double limit_mm) {
  const FloatLimits limits = floatLimits(fabric, limit_mm);
  for (int pick = 0; pick < fabric.weave.picks(); ++pick)
    for (int end = 0; end < fabric.weave.ends(); ++end)
      if (floatsTooFar(fabric.weave, pick, end, limits)) return true;
  return false;
}

/// What is marked, what is listed and the longest float that is said are one thing, on the face and on the back.
TEST(LongFloats, MarksListAndLongestFloatAgreeAtAnyLimit) {
  for (const Weave& weave : {satin(8, 3, Face::warp), satin(8, 3, Face::weft), twill(2, 2), basket(3, 3), plainWeave(),
                             shadedSatin(8, 3, 3), waffle(6)}) {
    const Fabric fabric = clothOf(weave);
    const Floats longest = floats(weave);
    const double longest_mm = std::max(floatLength_mm(fabric, System::warp, longest.warp()),
                                       floatLength_mm(fabric, System::weft, longest.weft()));
    for (const double limit_mm : {0.3, 0.99 * longest_mm, longest_mm, 1.01 * longest_mm}) {
      const LongFloats found = longFloats(fabric, limit_mm);
      EXPECT_EQ(found.count > 0, longest_mm > limit_mm) << longest_mm << " mm at most, limit " << limit_mm;
      EXPECT_EQ(marksAnything(fabric, limit_mm), longest_mm > limit_mm) << longest_mm << ", limit " << limit_mm;
      if (longest_mm > limit_mm) {
        EXPECT_DOUBLE_EQ(found.longest.front().length_mm, longest_mm);
      }
    }
  }
}

TEST(LongFloats, OfAWarpSatinTheWeftFloatsOnTheBack) {
  const Fabric fabric = clothOf(satin(8, 3, Face::warp));
  const LongFloats found = longFloats(fabric, 3);
  EXPECT_EQ(found.count, 8) << "a float of seven ends, 3.5 mm, on each of eight picks";
  for (const FloatRun& run : found.longest) {
    EXPECT_EQ(run.system, System::weft);
    EXPECT_FALSE(run.onFace);
    EXPECT_EQ(run.cells, 7);
    EXPECT_TRUE(fabric.weave.warpOver(run.across, run.first));
    EXPECT_FALSE(fabric.weave.warpOver(run.across, run.first - 1)) << "nothing binds it there";
    EXPECT_FALSE(fabric.weave.warpOver(run.across, run.first + run.cells));
  }
}

TEST(LongFloats, AThreadThatNothingBindsComesFirst) {
  const Fabric fabric = clothOf(Weave(std::vector<Weave::Row>{{1, 0, 1, 1}, {1, 1, 0, 1}}));
  const LongFloats found = longFloats(fabric, 50);
  ASSERT_EQ(found.count, 2) << "the first and the last end";
  EXPECT_TRUE(found.longest[0].isEndless);
  EXPECT_EQ(found.longest[0].across, 0);
  EXPECT_EQ(found.longest[1].across, 3);
}

TEST(LongFloats, OfManyTheLongestAreListed) {
  Fabric fabric = clothOf(basket(3, 3).resized(600, 600));
  std::vector<Weave::Row> rows(600, Weave::Row(600, 0));
  for (int pick = 0; pick < 600; ++pick)
    for (int end = 0; end < 600; ++end) rows[pick][end] = fabric.weave.warpOver(pick, end);
  for (int end = 100; end < 120; ++end) rows[7][end] = 0;
  fabric.weave = Weave(rows);
  const LongFloats found = longFloats(fabric, 0.6);
  EXPECT_GT(found.count, 100000);
  EXPECT_EQ(found.longest.size(), LongFloats::kMostListed);
  EXPECT_EQ(found.longest.front().across, 7);
  EXPECT_GE(found.longest.front().cells, 20);
}

}  // namespace
}  // namespace loomlight
