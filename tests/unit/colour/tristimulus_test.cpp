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
