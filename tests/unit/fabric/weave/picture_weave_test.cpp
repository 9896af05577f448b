#include "core/fabric/weave/picture_weave.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/random.h"
#include "core/fabric/weave/structures.h"

namespace loomlight {
namespace {

constexpr Rgb8 kBlack{0, 0, 0}, kRed{200, 10, 20}, kWhite{255, 255, 255};

ReducedPicture reduced(const Raster& raster, int colours) {
  return loomlight::reduced(raster, paletteOf(coloursOf(raster), colours));
}

/// Two rows: white red | black black.
Raster small() {
  return {2, 2, {kWhite, kRed, kBlack, kBlack}};
}

TEST(PictureWeave, FewColoursStayAsTheyAreFromDarkToLight) {
  const ReducedPicture picture = reduced(small(), 3);
  EXPECT_EQ(picture.palette, (std::vector<Rgb8>{kBlack, kRed, kWhite}));
  EXPECT_EQ(picture.colourOf, (std::vector<uint8_t>{2, 1, 0, 0}));
  EXPECT_EQ(picture.shares, (std::vector<double>{0.5, 0.25, 0.25}));
}

TEST(PictureWeave, NoisyGroupsOfColoursAreFoundAgain) {
  Random random(3);
  const Rgb8 groups[] = {{30, 40, 50}, {200, 60, 40}, {90, 160, 80}, {230, 220, 200}};
  Raster raster{64, 64, {}};
  std::vector<int> truth;
  for (int i = 0; i < 64 * 64; ++i) {
    truth.push_back(i * 7 / 64 % 4);
    Rgb8 c = groups[truth.back()];
    for (uint8_t& channel : c) channel = static_cast<uint8_t>(channel + static_cast<int>(random.uniform() * 20) - 10);
    raster.pixels.push_back(c);
  }
  const ReducedPicture picture = reduced(raster, 4);
  ASSERT_EQ(picture.palette.size(), 4u);
  // Every group has one colour, and no two the same.
  std::set<std::pair<int, int>> pairs;
  for (size_t i = 0; i < truth.size(); ++i) pairs.insert({truth[i], picture.colourOf[i]});
  EXPECT_EQ(pairs.size(), 4u);
  double all = 0;
  for (const double share : picture.shares) all += share;
  EXPECT_NEAR(all, 1, 1e-12);
}

TEST(PictureWeave, FewerColoursThanAskedForWhereThereAreNoMore) {
  Raster raster{40, 1, {}};
  for (int i = 0; i < 40; ++i) raster.pixels.push_back({static_cast<uint8_t>(i % 3), 0, 0});  // one bin
  EXPECT_EQ(reduced(raster, 2).palette.size(), 1u);
}

TEST(PictureWeave, SmallerIsTheMeanAndLargerAddsNoColour) {
  const Raster half = resampled({2, 1, {{10, 20, 30}, {20, 40, 60}}}, 1, 1);
  EXPECT_EQ(half.pixels, (std::vector<Rgb8>{{15, 30, 45}}));
  const Raster large = resampled(small(), 5, 7);
  EXPECT_EQ(large.pixels.size(), 35u);
  EXPECT_EQ(reduced(large, 32).palette, reduced(small(), 32).palette);
  EXPECT_EQ(large.pixels.front(), kWhite);
  EXPECT_EQ(large.pixels.back(), kBlack);
}

TEST(PictureWeave, EachColourIsWovenAsItsStructureIsThere) {
  Raster raster{16, 12, {}};
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 16; ++x) raster.pixels.push_back(x < 8 ? kBlack : kWhite);
  raster.pixels.front() = kRed;  // top left: the last pick, the first end
  const Weave weave = weaveOf(reduced(raster, 4), {satin(8, 3), plainWeave(), satin(8, 3, Face::weft)});
  EXPECT_EQ(weave.ends(), 16);
  EXPECT_EQ(weave.picks(), 12);
  for (int p = 0; p < 12; ++p)
    for (int e = 0; e < 16; ++e) {
      const Weave structure = p == 11 && e == 0 ? plainWeave() : e < 8 ? satin(8, 3) : satin(8, 3, Face::weft);
      EXPECT_EQ(weave.at(p, e), structure.warpOver(p, e)) << p << ' ' << e;
    }
}

}  // namespace
}  // namespace loomlight
