#include "app/export/sample_box.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

constexpr int kSide = 6, kSamples = 5;
const SampleBox kPicture = SampleBox::of({0, 0, kSide, kSide}, 0, kSamples);

/// How many of the boxes hold each sample of the picture.
std::vector<int> countedIn(const std::vector<SampleBox>& boxes) {
  std::vector<int> counts;
  for (int z = 0; z < kSamples; ++z)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        counts.push_back(static_cast<int>(std::count_if(boxes.begin(), boxes.end(), [&](const SampleBox& box) {
          const glm::ivec3 at(x, y, z);
          return glm::all(glm::lessThanEqual(box.low, at)) && glm::all(glm::lessThan(at, box.high));
        })));
  return counts;
}

/// The picture in pieces, by cuts at random, of which every third is left out.
std::vector<SampleBox> somePieces(Random& random) {
  std::vector<SampleBox> pieces{kPicture};
  for (int cuts = 0; cuts < 12; ++cuts) {
    const size_t i = random.below(static_cast<uint32_t>(pieces.size()));
    const auto axis = static_cast<int>(random.below(3));
    const int length = pieces[i].high[axis] - pieces[i].low[axis];
    if (length < 2) continue;
    SampleBox rest = pieces[i];
    rest.low[axis] = pieces[i].high[axis] =
        pieces[i].low[axis] + 1 + static_cast<int>(random.below(static_cast<uint32_t>(length - 1)));
    pieces.push_back(rest);
  }
  std::erase_if(pieces, [&](const SampleBox&) { return random.below(3) == 0; });
  return pieces;
}

TEST(SampleBox, MissingIsWhatNoBoxHolds) {
  Random random(7);
  for (int round = 0; round < 200; ++round) {
    const std::vector<SampleBox> pieces = somePieces(random);
    const std::vector<int> held = countedIn(pieces), missing = countedIn(missingFrom(kPicture, pieces));
    for (size_t i = 0; i < held.size(); ++i) ASSERT_EQ(held[i] + missing[i], 1) << round;
  }
}

TEST(SampleBox, JoiningKeepsEverySampleOnce) {
  Random random(8);
  for (int round = 0; round < 200; ++round) {
    const std::vector<SampleBox> pieces = somePieces(random), fewer = joined(pieces);
    EXPECT_LE(fewer.size(), pieces.size());
    ASSERT_EQ(countedIn(pieces), countedIn(fewer)) << round;
  }
}

TEST(SampleBox, AGridOfPartsIsOneBox) {
  std::vector<SampleBox> grid;
  for (int z = 0; z < kSamples; ++z)
    for (int y = 0; y < kSide; y += 2)
      for (int x = 0; x < kSide; x += 3) grid.push_back(SampleBox::of({x, y, 3, 2}, z, 1));
  EXPECT_EQ(joined(grid), std::vector{kPicture});
  EXPECT_TRUE(missingFrom(kPicture, grid).empty());
  EXPECT_EQ(windowAround(grid), kPicture.window());
}

TEST(SampleBox, OverlapIsFoundWhereOneSampleIsShared) {
  const SampleBox a = SampleBox::of({0, 0, 3, 3}, 0, 2), b = SampleBox::of({3, 0, 3, 3}, 0, 2),
                  c = SampleBox::of({0, 0, 3, 3}, 2, 2), d = SampleBox::of({2, 2, 2, 2}, 1, 1);
  EXPECT_FALSE(findOverlap(std::vector{a, b, c}));
  EXPECT_EQ(findOverlap(std::vector{c, b, d}), std::pair(size_t{1}, size_t{2}));
}

TEST(SampleBox, IsSaidInWords) {
  EXPECT_THAT(inWords(SampleBox::of({1, 2, 30, 40}, 64, 64)), HasSubstr("samples 64 to 127"));
  EXPECT_THAT(inWords(SampleBox::of({1, 2, 30, 40}, 64, 64)), HasSubstr("1,2,30x40"));
}

}  // namespace
}  // namespace loomlight
