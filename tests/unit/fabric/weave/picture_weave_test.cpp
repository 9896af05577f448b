#include "core/fabric/weave/picture_weave.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// A disc on a ground, drawn with smooth edges, beside a stripe.
Raster smoothDisc(const Rgb8& ground, const Rgb8& disc, const Rgb8& stripe, bool inLinearLight) {
  constexpr int kSide = 60, kFine = 8;
  const double power = inLinearLight ? 2.2 : 1;
  Raster raster{kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      double sum[3] = {0, 0, 0};
      for (int i = 0; i < kFine * kFine; ++i) {
        const double u = x + (i % kFine + 0.5) / kFine, v = y + (i / kFine + 0.5) / kFine;
        const bool isInside = (u - 25) * (u - 25) + (v - 30) * (v - 30) < 20 * 20;
        const Rgb8& colour = u > 51.5 ? stripe : isInside ? disc : ground;
        for (size_t c = 0; c < 3; ++c) sum[c] += std::pow(colour[c] / 255.0, power) / (kFine * kFine);
      }
      Rgb8& pixel = raster.pixels.emplace_back();
      for (size_t c = 0; c < 3; ++c) pixel[c] = static_cast<uint8_t>(std::lround(255 * std::pow(sum[c], 1 / power)));
    }
  return raster;
}

TEST(PictureWeave, TheMixedColoursOfSmoothEdgesAreNoColoursOfTheirOwn) {
  constexpr Rgb8 kGrey{128, 128, 128}, kTeal{0, 160, 150};
  struct Drawing {
    Rgb8 ground, disc, stripe;
  };
  for (const bool inLinearLight : {false, true})
    for (const Drawing& drawing :
         {Drawing{kWhite, kBlack, kGrey}, Drawing{kBlack, kWhite, kGrey}, Drawing{kRed, kTeal, kWhite}}) {
      SCOPED_TRACE(inLinearLight);
      const Raster raster = smoothDisc(drawing.ground, drawing.disc, drawing.stripe, inLinearLight);
      const ReducedPicture picture = reduced(raster, 6);
      std::vector<Rgb8> areas{drawing.ground, drawing.disc, drawing.stripe}, found = picture.palette;
      std::sort(areas.begin(), areas.end());
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, areas) << "six were allowed";
      int wrong = 0;  // the rim of a black disc on white is no grey line
      for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < 49; ++x)
          wrong +=
              picture.palette[picture.colourOf[static_cast<size_t>(y) * 60 + static_cast<size_t>(x)]] == drawing.stripe;
      EXPECT_EQ(wrong, 0);
    }
}

TEST(PictureWeave, SmallerPicturesGetNoColoursBetweenTheirAreas) {
  constexpr Rgb8 kGrey{128, 128, 128};
  const Raster raster = smoothDisc(kWhite, kBlack, kGrey, false);
  const ReducedPicture picture = loomlight::reduced(resampled(raster, 23, 37), {kBlack, kGrey, kWhite});
  for (int y = 0; y < 37; ++y)
    for (int x = 0; x < 18; ++x) EXPECT_NE(picture.colourOf[static_cast<size_t>(y) * 23 + x], 1) << x << ' ' << y;
}

TEST(PictureWeave, ThinLinesOfADrawingMadeOfPixelsStay) {
  constexpr Rgb8 kGrey{128, 128, 128};
  Raster raster{9, 4, {}};
  for (int i = 0; i < 36; ++i) raster.pixels.push_back(i % 9 < 4 ? kBlack : i % 9 == 4 ? kGrey : kWhite);
  const ReducedPicture picture = reduced(raster, 3);
  EXPECT_EQ(picture.palette, (std::vector<Rgb8>{kBlack, kGrey, kWhite}));
  EXPECT_NEAR(picture.shares[1], 1.0 / 9, 1e-12);
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
