#include "render/colour/tristimulus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render/colour/colour_space.h"
#include "tests/unit/colour/reference_weights.h"

namespace loomlight {
namespace {

Spectrum grey(float value) {
  Spectrum spectrum;
  spectrum.fill(value);
  return spectrum;
}

/// Half of them jump from band to band, half are as smooth as dyes: a step somewhere, of some width.
std::vector<Spectrum> hundredReflectances() {
  std::mt19937 random(18);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Spectrum> all(100);
  for (size_t i = 0; i < all.size(); ++i) {
    const float middle_nm = 380 + 350 * unit(random), width_nm = 5 + 60 * unit(random), from = unit(random),
                to = unit(random);
    for (size_t j = 0; j < kBands; ++j)
      all[i][j] =
          i % 2 ? unit(random) : std::lerp(from, to, 1 / (1 + std::exp((middle_nm - bandWavelength_nm(j)) / width_nm)));
  }
  return all;
}

TEST(TristimulusWeights, AgreeWithAnIndependentImplementation) {
  for (const ReferenceWeights& reference : kReferenceWeights) {
    const TristimulusWeights weights = tristimulusWeights(illuminantNamed(reference.illuminant), reference.observer);
    for (const Spectrum& reflectance : hundredReflectances()) {
      const glm::dvec3 mine = weighted(weights, reflectance), theirs = weighted(reference.rows, reflectance);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(mine[i], theirs[i], 1e-4) << reference.illuminant;
    }
  }
}

TEST(TristimulusWeights, MakeAWhiteOfLuminanceOneUnderEveryLight) {
  for (const std::string& name : lampNames())
    for (const Observer observer : {Observer::degrees2, Observer::degrees10})
      EXPECT_NEAR(whiteXyz(tristimulusWeights(illuminantNamed(name), observer)).y, 1, 1e-6) << name;
}

/// A cubic between bands must not lose the light between them: a lamp of one line between two bands.
TEST(TristimulusWeights, OfALineAreTheFunctionsAtItsWavelength) {
  Illuminant line{"line"};
  line.power[546 - kFirstVisible_nm] = 1;
  const glm::dvec3 functions = matchingFunctions(Observer::degrees10)[546 - kFirstVisible_nm];
  const TristimulusWeights weights = tristimulusWeights(line, Observer::degrees10);
  const glm::dvec3 white = whiteXyz(weights);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], functions[i] / functions.y, 1e-6);
  Spectrum slope;  // a straight reflectance is met exactly
  for (size_t j = 0; j < kBands; ++j) slope[j] = static_cast<float>(bandWavelength_nm(j)) / 1000;
  EXPECT_NEAR(weighted(weights, slope).y, 0.546, 1e-6);
}

TEST(LinearWeights, LeaveGreysGreyUnderEveryLight) {
  for (const std::string& name : lampNames())
    for (const Observer observer : {Observer::degrees2, Observer::degrees10}) {
      const glm::dvec3 linear = weighted(linearWeights(illuminantNamed(name), observer), grey(0.25f));
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(linear[c], 0.25, 1e-6) << name;
    }
}

/// Bradford from A to D65, as B. Lindbloom publishes it, with white points of ASTM E308.
TEST(Bradford, IsThePublishedMatrix) {
  const glm::dmat3 matrix = bradford({1.09850, 1, 0.35585}, {0.95047, 1, 1.08883});
  const double published[3][3] = {
      {0.8446965, -0.1179225, 0.3948108}, {-0.1366303, 1.1041226, 0.1291718}, {0.0798489, -0.1348999, 3.1924009}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) EXPECT_NEAR(matrix[column][row], published[row][column], 2e-6);
}

struct Adapted {
  glm::dvec3 xyz, white, otherWhite, otherXyz;
};

// Made by tests/references/colour_adaptation.py; not by Loomlight.
const Adapted kAdapted[] = {
    {{0.285526, 0.101070, 0.790158},
     {0.967206, 1.000000, 0.814280},
     {1.038197, 1.000000, 0.655550},
     {0.273025, 0.099381, 0.632494}},
    {{0.672574, 0.585334, 0.335189},
     {1.032450, 1.000000, 0.689897},
     {1.038197, 1.000000, 0.655550},
     {0.677158, 0.585977, 0.318485}},
    {{0.717168, 0.909241, 0.725385},
     {0.967206, 1.000000, 0.814280},
     {1.111420, 1.000000, 0.351998},
     {0.823819, 0.889574, 0.316979}},
    {{0.043424, 0.743278, 0.553017},
     {0.967206, 1.000000, 0.814280},
     {1.038197, 1.000000, 0.655550},
     {0.050618, 0.705908, 0.449740}},
    {{0.136285, 0.633643, 0.849159},
     {0.948097, 1.000000, 1.073051},
     {1.038197, 1.000000, 0.655550},
     {0.118872, 0.585846, 0.523989}},
    {{0.874736, 0.148019, 0.416550},
     {0.948097, 1.000000, 1.073051},
     {1.032450, 1.000000, 0.689897},
     {0.952797, 0.202398, 0.256915}},
    {{0.579771, 0.399965, 0.578660},
     {1.038197, 1.000000, 0.655550},
     {1.032450, 1.000000, 0.689897},
     {0.579524, 0.400110, 0.609860}},
    {{0.830576, 0.343286, 0.679461},
     {0.948097, 1.000000, 1.073051},
     {1.032450, 1.000000, 0.689897},
     {0.893543, 0.376660, 0.428503}},
    {{0.194641, 0.733698, 0.093854},
     {1.038197, 1.000000, 0.655550},
     {0.948097, 1.000000, 1.073051},
     {0.138625, 0.764603, 0.132561}},
    {{0.196109, 0.406850, 0.760363},
     {0.948097, 1.000000, 1.073051},
     {1.111420, 1.000000, 0.351998},
     {0.168952, 0.357647, 0.250109}},
    {{0.249183, 0.070845, 0.027567},
     {1.038197, 1.000000, 0.655550},
     {1.111420, 1.000000, 0.351998},
     {0.270615, 0.083155, 0.012127}},
    {{0.785760, 0.353507, 0.236746},
     {1.038197, 1.000000, 0.655550},
     {1.111420, 1.000000, 0.351998},
     {0.845615, 0.381209, 0.120027}},
    {{0.911694, 0.942251, 0.760380},
     {0.967206, 1.000000, 0.814280},
     {1.038197, 1.000000, 0.655550},
     {0.978931, 0.942390, 0.612178}},
    {{0.731899, 0.582789, 0.148259},
     {1.111420, 1.000000, 0.351998},
     {1.038197, 1.000000, 0.655550},
     {0.673878, 0.574308, 0.275854}},
    {{0.718253, 0.739312, 0.671580},
     {0.948097, 1.000000, 1.073051},
     {1.038197, 1.000000, 0.655550},
     {0.798035, 0.744862, 0.410892}},
    {{0.707444, 0.758519, 0.583136},
     {0.967206, 1.000000, 0.814280},
     {1.032450, 1.000000, 0.689897},
     {0.756600, 0.757692, 0.494265}},
};

TEST(Bradford, AgreesWithAnIndependentImplementation) {
  for (const Adapted& row : kAdapted) {
    const glm::dvec3 mine = bradford(row.white, row.otherWhite) * row.xyz;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(mine[i], row.otherXyz[i], 1e-6) << &row - kAdapted;
  }
}

/// Under D65 nothing needs adapting: XYZ goes through the matrix of Rec. 709 as it is, but for the digits of its white.
TEST(LinearWeights, UnderD65AreThoseOfRec709) {
  const Illuminant d65 = illuminantNamed("D65");
  for (const Spectrum& reflectance : hundredReflectances()) {
    const glm::dvec3 xyz = weighted(tristimulusWeights(d65, Observer::degrees2), reflectance);
    const glm::dvec3 plain = linearFromWhiteXyz(xyz / d65Xyz());
    const glm::dvec3 linear = weighted(linearWeights(d65, Observer::degrees2), reflectance);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(linear[c], plain[c], 1e-3);
  }
}

}  // namespace
}  // namespace loomlight
