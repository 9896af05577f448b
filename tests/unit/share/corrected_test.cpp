#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "render/share/shared_picture.h"

namespace loomlight {
namespace {

/// Of cells that say: one half, with so much noise a path.
SharedPicture grey(float variance) {
  SharedPicture picture(64, 64);
  std::ranges::fill(picture.light, Rgb(0.5f));
  std::ranges::fill(picture.alpha, 1.0f);
  std::ranges::fill(picture.variances, variance);
  return picture;
}

TEST(Corrected, ComesToTheFilmAsItsSamplesGrow) {
  const SharedPicture shared = grey(1.0f);
  Film film(64, 64);
  PathSample sample;
  sample.alpha = 1;
  sample.direct = Rgb(0.8f);
  float before = 0.5f;
  uint32_t samples = 0;
  for (const uint32_t upTo : {1u, 4u, 16u, 64u, 256u, 1024u}) {
    for (; samples < upTo; ++samples)
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) film.add(x, y, samples, sample);
    const float now = corrected(shared, film, {}, 1024, 1)[64 * 32 + 32].r;
    EXPECT_GE(now, before - 1e-5f) << upTo;
    EXPECT_LE(now, 0.8f + 1e-5f) << upTo;
    before = now;
  }
  EXPECT_EQ(before, film.mean(32, 32).r);
}

/// A sample that meets cloth and brings light or none, by a coin, so that its mean is `mean`, at most 1/2.
PathSample coin(Random& random, float mean) {
  PathSample sample;
  sample.alpha = 1;
  sample.direct = random.below(2) == 0 ? Rgb(0) : Rgb(2 * mean);
  return sample;
}

/// One path a pixel of a picture of 64 x 64 at 1/divider of the resolution. The film's left half is in the shade.
CoarseFilm halfInShade(int divider, float inShade) {
  const int side = 64 / divider;
  CoarseFilm seen{Film(side, side), divider};
  Random random(5);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) seen.film.add(x, y, 0, coin(random, x < side / 2 ? inShade : 0.5f));
  return seen;
}

/// A film of a picture of 64 x 64 that is that bright above row `to`, with as much noise a path.
Film noisyAbove(int to, float mean) {
  Film film(64, 64);
  Random random(5);
  for (int y = 0; y < to; ++y)
    for (int x = 0; x < 64; ++x) film.add(x, y, 0, coin(random, mean));
  return film;
}

/// What the middles of the left and of the right half show.
glm::vec2 meansOfHalves(const std::vector<glm::vec4>& picture) {
  glm::dvec2 sums(0);
  for (size_t y = 0; y < 64; ++y)
    for (size_t x = 0; x < 24; ++x) sums += glm::dvec2(picture[64 * y + x].r, picture[64 * y + 63 - x].r);
  return sums / (64.0 * 24);
}

// Cells do not know of the shade that one half of the picture is in; a single noisy sample of its pixels does.
TEST(Corrected, SeesTheShadeThatCellsDoNotKnow) {
  const glm::vec2 means = meansOfHalves(corrected(grey(0.75f), halfInShade(1, 0.1f).film, {}, 1024, 1));
  // Within a quarter of the cells' error, which was 0.4 here and nothing there.
  EXPECT_NEAR(means[0], 0.1, 0.1);
  EXPECT_NEAR(means[1], 0.5, 0.1);
}

// As long as a fine pass is under way, most pixels have no samples of their own.
TEST(Corrected, SeesTheShadeThatOnlyCoarserPassesHaveSeen) {
  std::vector<CoarseFilm> coarser{halfInShade(4, 0.5f), halfInShade(2, 0.1f)};  // of which the finer one counts
  const glm::vec2 means = meansOfHalves(corrected(grey(0.75f), Film(64, 64), coarser, 1024, 1));
  EXPECT_NEAR(means[0], 0.1, 0.1);
  EXPECT_NEAR(means[1], 0.5, 0.1);
}

// What has samples of its own is as these say, and all around as coarser passes do.
TEST(Corrected, BelievesEachFilmInItsPlace) {
  const std::vector<CoarseFilm> coarser{halfInShade(2, 0.5f)};
  const std::vector<glm::vec4> picture = corrected(grey(0.75f), noisyAbove(32, 0.1f), coarser, 1024, 1);
  double above = 0, below = 0;
  for (size_t i = 0; i < size_t{64} * 24; ++i)
    above += picture[i].r / (64 * 24), below += picture[4095 - i].r / (64 * 24);
  EXPECT_NEAR(above, 0.1, 0.1);
  EXPECT_NEAR(below, 0.5, 0.1);
}

// Parts of a coarse pixel cannot differ, and tell nothing of how large the error of the cells is at their size.
TEST(Corrected, SeesAsFineWhereOtherPlacesHaveCoarseSamplesAlone) {
  Film film(64, 64);
  Random random(5);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 64; ++x)
      for (uint32_t i = 0; i < 8; ++i) film.add(x, y, i, coin(random, x % 8 < 4 ? 0.1f : 0.5f));
  const std::vector<CoarseFilm> coarser{halfInShade(8, 0.5f)};
  const auto contrast = [&](std::span<const CoarseFilm> others) {
    const std::vector<glm::vec4> picture = corrected(grey(0.75f), film, others, 1024, 1);
    double sum = 0;
    for (size_t i = 0; i < size_t{64} * 16; ++i) sum += (i % 8 < 4 ? -picture[i].r : picture[i].r) / (32 * 16);
    return sum;
  };
  EXPECT_GT(contrast(coarser), 0.9 * contrast({}));
}

// A picture whose sides are no multiple of a block's is bright to its rims, and so are places that no film has seen.
TEST(Corrected, BrightensRimsAndWhatNobodyHasSeen) {
  constexpr int kSide = 61, kDivider = 3, kCoarse = 21;
  SharedPicture shared(kSide, kSide);
  std::ranges::fill(shared.light, Rgb(0.5f));
  std::ranges::fill(shared.alpha, 1.0f);
  std::ranges::fill(shared.variances, 0.75f);
  std::vector<CoarseFilm> coarser{{Film(kCoarse, kCoarse), kDivider}};
  Random random(5);
  for (int y = 0; y < kCoarse; ++y)
    for (int x = 0; x < kCoarse; ++x)
      if (x != 5 || y != 5) coarser[0].film.add(x, y, 0, coin(random, 0.1f));
  const std::vector<glm::vec4> picture = corrected(shared, Film(kSide, kSide), coarser, 1024, 1);
  for (const auto& [x, y] : {std::pair{60, 20}, {20, 60}, {60, 60}, {16, 16}})
    EXPECT_NEAR(picture[static_cast<size_t>(y * kSide + x)].r, 0.1, 0.1) << x << ", " << y;
}

TEST(Corrected, NeedsNoCoarserPassesWhereTheFilmHasSamples) {
  const Film film = halfInShade(1, 0.5f).film;
  const std::vector<CoarseFilm> coarser{halfInShade(2, 0.1f)};
  EXPECT_EQ(corrected(grey(0.75f), film, coarser, 1024, 1), corrected(grey(0.75f), film, {}, 1024, 1));
}

/// The mean square of what is shown from what cells say rightly.
double noiseLeft(const std::vector<glm::vec4>& picture) {
  double square = 0;
  for (const glm::vec4& pixel : picture) square += (pixel.r - 0.5) * (pixel.r - 0.5) / (64 * 64);
  return square;
}

TEST(Corrected, LeavesWhatIsNoisyAlone) {
  const double ofFilm = 0.25;  // the variance of a coin
  EXPECT_LT(noiseLeft(corrected(grey(0.75f), halfInShade(1, 0.5f).film, {}, 1024, 1)), 0.02 * ofFilm);
  // Four pixels, or sixteen, have one sample of a coarse film, so what blocks of them say has as much more noise.
  for (const int divider : {2, 4})
    EXPECT_LT(noiseLeft(corrected(grey(0.75f), Film(64, 64), {{halfInShade(divider, 0.5f)}}, 1024, 1)), 0.02 * ofFilm)
        << divider;
}

}  // namespace
}  // namespace loomlight
