#include "core/fabric/weave/yarn_sequence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/fabric/model/changes.h"
#include "core/fabric/model/colourways.h"

namespace loomlight {
namespace {

using Sequence = std::vector<int>;

TEST(YarnSequence, MirrorsOnItsOutermostThreads) {
  EXPECT_EQ(mirrored({0, 1, 2}), (Sequence{0, 1, 2, 1}));
  EXPECT_EQ(mirrored({0, 0, 1, 2}), (Sequence{0, 0, 1, 2, 1, 0}));
  EXPECT_EQ(mirrored({0, 1}), (Sequence{0, 1}));
  EXPECT_EQ(mirrored({3}), (Sequence{3}));
  EXPECT_EQ(reversed({0, 1, 1, 2}), (Sequence{2, 1, 1, 0}));
  EXPECT_EQ(widened({0, 1}, 3), (Sequence{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(repeated({0, 1}, 3), (Sequence{0, 1, 0, 1, 0, 1}));
}

TEST(RandomStripes, KeepToTheirWidthsAndYarns) {
  const StripeChance chance{400, 3, 7, 5};
  const Sequence sequence = randomStripes({1, 0, 2}, chance);
  ASSERT_EQ(sequence.size(), 400u);
  EXPECT_EQ(std::count(sequence.begin(), sequence.end(), 1), 0) << "a yarn of no weight";
  size_t start = 0;
  for (size_t i = 1; i < sequence.size(); ++i) {
    if (sequence[i] == sequence[start]) continue;
    EXPECT_GE(i - start, 3u);
    EXPECT_LE(i - start, 7u);
    start = i;
  }
}

TEST(RandomStripes, FollowTheirWeightsAndTheirSeed) {
  StripeChance chance{16000, 1, 3, 1};
  const Sequence sequence = randomStripes({1, 1, 1, 1}, chance);
  for (int yarn = 0; yarn < 4; ++yarn)
    EXPECT_NEAR(static_cast<double>(std::count(sequence.begin(), sequence.end(), yarn)) / 16000, 0.25, 0.02);
  EXPECT_EQ(sequence, randomStripes({1, 1, 1, 1}, chance));
  chance.seed = 2;
  EXPECT_NE(sequence, randomStripes({1, 1, 1, 1}, chance));
  EXPECT_EQ(randomStripes({0, 5}, {9, 2, 4, 1}), Sequence(9, 1)) << "one yarn alone has no stripes";
}

TEST(Colourways, ThereAndBackAndNothingButColour) {
  Fabric fabric;
  fabric.fibres.resize(2);
  const Colourway plain = colourwayOf(fabric, "undyed");
  fabric.fibres[1].absorption_per_mm = Rgb(3.0f, 20.0f, 40.0f);
  const Colourway rust = colourwayOf(fabric, "rust");
  EXPECT_EQ(inColourway(inColourway(fabric, plain), rust), fabric);
  EXPECT_EQ(changes(fabric, inColourway(fabric, plain)).stages, Stages(Stage::colour));
}

TEST(Colourways, FibresThatItDoesNotKnowKeepTheirs) {
  Fabric fabric;
  const Colourway one = colourwayOf(fabric, "one");
  fabric.fibres.resize(2);
  fabric.fibres[1].absorption_per_mm = Rgb(7.0f);
  EXPECT_EQ(inColourway(fabric, one).fibres[1].absorption_per_mm, Rgb(7.0f));
}

}  // namespace
}  // namespace loomlight
