#include "render/colour/colour_difference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loomlight {
namespace {

struct Pair {
  Lab standard, sample;
  double twoToOne, oneToOne;
};

// Made by tests/references/colour_differences.py; not by Loomlight.
const Pair kReference[] = {
    {{40.33, 26.09, -26.3}, {38.11, 30.12, -24.45}, 3.06853, 3.65818},
    {{63.85, 9.22, -2.96}, {69.52, 7.37, -0.83}, 3.52829, 5.32775},
    {{89.11, 46.63, 53.8}, {90.12, 48.78, 52.75}, 1.96484, 2.05923},
    {{62.02, 16.51, -44.85}, {62.05, 14.97, -44.6}, 0.97252, 0.97276},
    {{90.42, -44.32, -14.92}, {91.81, -45.64, -13.53}, 1.08827, 1.37685},
    {{39.22, 45.64, -12.41}, {41.02, 47.16, -12.4}, 1.13540, 1.99590},
    {{83.58, -45.62, -39.49}, {81.29, -45.63, -39.71}, 0.83298, 1.65782},
    {{20.3, -12.63, 24.32}, {22.98, -16.62, 21.49}, 4.17225, 5.63668},
    {{6.98, -57.3, -43.82}, {6.96, -55.3, -46.86}, 1.63209, 1.63244},
    {{35.16, -31.12, 52.97}, {34.02, -32.09, 48.51}, 2.05325, 2.33434},
    {{64.55, 8.91, -10.87}, {62.36, 7.71, -10.82}, 1.44624, 2.10828},
    {{72.46, 14.19, -1.54}, {71.46, 14.14, -0.3}, 1.28715, 1.44866},
    {{16.93, -29.72, 20.63}, {17.65, -31.68, 21.76}, 1.23008, 1.69588},
    {{90.61, -51.39, 1.26}, {89.55, -50.96, 1.79}, 0.48957, 0.80791},
    {{6.63, -55.29, -28.75}, {3.3, -52.27, -28.84}, 3.46059, 6.62009},
    {{64.26, -19.69, 57.83}, {62.8, -17.91, 53.91}, 1.65441, 1.94612},
    {{23.44, -31.25, 36.48}, {21.38, -31.24, 37.87}, 1.64448, 3.09836},
    {{96.74, -44.46, -47.77}, {96.96, -43.85, -47.77}, 0.26904, 0.29886},
    {{34.36, 2.01, 47.09}, {34.73, 1.18, 45.4}, 0.89772, 0.96932},
    {{64.37, -11.49, -35.59}, {68.6, -12.3, -41.22}, 3.09707, 4.28883},
    {{52.31, 42.09, 34.92}, {53.64, 43.33, 33.65}, 1.54183, 1.85618},
    {{15.98, -53.29, -55.05}, {13.74, -54.37, -52.11}, 2.57041, 4.58462},
    {{64.29, -32.53, 3.63}, {61.29, -32.73, 2.7}, 1.35659, 2.50459},
    {{12.98, -41.65, -30.98}, {15.4, -42.49, -32.42}, 2.46273, 4.78393},
};

TEST(CmcDifference, AgreesWithAnIndependentImplementation) {
  for (const Pair& pair : kReference) {
    EXPECT_NEAR(cmcDifference(pair.standard, pair.sample), pair.twoToOne, 1e-4);
    EXPECT_NEAR(cmcDifference(pair.standard, pair.sample, 1, 1), pair.oneToOne, 1e-4);
  }
}

TEST(CmcDifference, OfAGreyHasNoHueToBeWrong) {
  EXPECT_EQ(cmcDifference({50, 0, 0}, {50, 0, 0}), 0);
  EXPECT_NEAR(cmcDifference({50, 0, 0}, {50, 1, 0}), cmcDifference({50, 0, 0}, {50, 0, 1}), 1e-12);
  EXPECT_TRUE(std::isfinite(cmcDifference({0, 0, 0}, {100, 0, 0})));
}

TEST(LchDifference, AddsUpToTheDistanceInCielab) {
  for (const Pair& pair : kReference) {
    const LchDifference by = lchDifference(pair.standard, pair.sample);
    const double distance =
        std::hypot(pair.sample.L - pair.standard.L, pair.sample.a - pair.standard.a, pair.sample.b - pair.standard.b);
    EXPECT_NEAR(std::hypot(by.L, by.C, by.H), distance, 1e-9);
  }
}

/// Each is the sample's less the standard's; a hue grows from red over yellow and green to blue.
TEST(LchDifference, SaysWhichWayTheSampleIsOff) {
  EXPECT_EQ(lchDifference({40, 20, 0}, {43, 20, 0}).L, 3);
  EXPECT_EQ(lchDifference({40, 20, 0}, {40, 15, 0}).C, -5);
  EXPECT_GT(lchDifference({40, 20, 0}, {40, 20, 1}).H, 0) << "a red that is yellower";
  EXPECT_LT(lchDifference({40, 20, 0}, {40, 20, -1}).H, 0) << "a red that is bluer";
  EXPECT_GT(lchDifference({40, -20, 1}, {40, -20, -1}).H, 0) << "a green that is bluer, across the half turn";
  EXPECT_EQ(lchDifference({40, 0, 0}, {40, 3, 4}).H, 0) << "a grey has no hue";
}

TristimulusWeights under(const char* illuminant) {
  return tristimulusWeights(illuminantNamed(illuminant), Observer::degrees10);
}

Spectrum slope(float from, float to) {
  Spectrum spectrum;
  for (size_t j = 0; j < kBands; ++j) spectrum[j] = std::lerp(from, to, static_cast<float>(j) / (kBands - 1));
  return spectrum;
}

/// A change of reflectance that nobody sees under a light: orthogonal to the weights of X, Y and Z (metameric black).
Spectrum unseen(Spectrum change, const TristimulusWeights& weights) {
  std::array<std::array<double, kBands>, 3> basis;
  for (size_t row = 0; row < 3; ++row) {
    for (size_t j = 0; j < kBands; ++j) basis[row][j] = weights.rows[row][j];
    for (size_t other = 0; other <= row; ++other) {
      double dot = 0;
      for (size_t j = 0; j < kBands; ++j) dot += basis[row][j] * basis[other][j];
      for (size_t j = 0; j < kBands; ++j)
        other < row ? basis[row][j] -= dot * basis[other][j] : basis[row][j] /= std::sqrt(dot);
    }
  }
  for (const auto& direction : basis) {
    double dot = 0;
    for (size_t j = 0; j < kBands; ++j) dot += direction[j] * change[j];
    for (size_t j = 0; j < kBands; ++j) change[j] -= static_cast<float>(dot * direction[j]);
  }
  return change;
}

Spectrum plus(Spectrum one, const Spectrum& other) {
  for (size_t j = 0; j < kBands; ++j) one[j] += other[j];
  return one;
}

TEST(LabUnder, GreysAreNeutralUnderEveryLight) {
  for (const char* name : {"D65", "A", "F11"}) {
    const Lab lab = labUnder(under(name), slope(0.184187f, 0.184187f));
    EXPECT_NEAR(lab.L, 50, 1e-3) << name;
    EXPECT_NEAR(lab.a, 0, 1e-9) << name;
    EXPECT_NEAR(lab.b, 0, 1e-9) << name;
  }
}

/// Both ways from a reflectance to a colour on the screen, by weights of linear light and by CIELAB, are the same.
TEST(LinearUnder, IsTheColourThatTheReflectanceHas) {
  for (const char* name : {"D50", "D65", "F11"}) {
    const glm::dvec3 straight = weighted(linearWeights(illuminantNamed(name), Observer::degrees10), slope(0.2f, 0.7f));
    const glm::dvec3 byLab = linearUnder(whiteXyz(under(name)), labUnder(under(name), slope(0.2f, 0.7f)));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(byLab[c], straight[c], 1e-6) << name;
  }
}

TEST(MetamerismIndex, IsTheDifferenceUnderTheOtherLightOfTwoThatMatch) {
  const TristimulusWeights d65 = under("D65"), f11 = under("F11");
  const Spectrum standard = slope(0.3f, 0.6f);
  Spectrum waves;
  for (size_t j = 0; j < kBands; ++j) waves[j] = 0.1f * std::sin(0.9f * static_cast<float>(j));
  const Spectrum sample = plus(standard, unseen(waves, d65));
  ASSERT_LT(ciede2000(labUnder(d65, standard), labUnder(d65, sample)), 1e-3);
  const double seen = ciede2000(labUnder(f11, standard), labUnder(f11, sample));
  EXPECT_GT(seen, 1);
  EXPECT_NEAR(metamerismIndex(standard, sample, d65, f11), seen, 1e-3);
  EXPECT_LT(metamerismIndex(standard, sample, d65, d65), 1e-9);
}

/// A pair that matches by day and parts in the shop: each figure is of the lamp that it is said of, and CMC decides.
TEST(Judged, IsUnderItsLampAndPassesByCmc) {
  const TristimulusWeights d65 = under("D65"), f11 = under("F11");
  const Spectrum standard = slope(0.3f, 0.6f), sample = slope(0.32f, 0.6f);
  Spectrum waves;
  for (size_t j = 0; j < kBands; ++j) waves[j] = 0.1f * std::sin(0.9f * static_cast<float>(j));
  const Spectrum metamer = plus(standard, unseen(waves, d65));
  const Judgement byDay = judged(standard, metamer, d65, d65), inShop = judged(standard, metamer, f11, d65);
  EXPECT_TRUE(byDay.passes(0.01));
  EXPECT_FALSE(inShop.passes(0.5));
  EXPECT_NEAR(inShop.metamerism, inShop.ciede2000, 1e-3) << "all of it is the lamp's doing";
  const Judgement off = judged(standard, sample, f11, d65);
  EXPECT_EQ(off.standard.L, labUnder(f11, standard).L);
  EXPECT_EQ(off.sample.b, labUnder(f11, sample).b);
  EXPECT_EQ(off.cmc, cmcDifference(off.standard, off.sample)) << "the standard says how large the ellipsoid is";
  EXPECT_EQ(off.ciede2000, ciede2000(off.standard, off.sample));
  EXPECT_TRUE(off.passes(off.cmc));
  EXPECT_FALSE(off.passes(0.99 * off.cmc));
}

/// A sample that is lighter throughout is no metamer: the correction takes the whole difference away.
TEST(MetamerismIndex, IsNoneForTheSameSpectrumInAnotherStrength) {
  const Spectrum standard = slope(0.3f, 0.6f), sample = slope(0.36f, 0.72f);
  EXPECT_GT(ciede2000(labUnder(under("A"), standard), labUnder(under("A"), sample)), 3);
  EXPECT_NEAR(metamerismIndex(standard, sample, under("D65"), under("A")), 0, 1e-4);
  EXPECT_TRUE(std::isfinite(metamerismIndex(standard, slope(0, 0), under("D65"), under("A"))));
}

}  // namespace
}  // namespace loomlight
