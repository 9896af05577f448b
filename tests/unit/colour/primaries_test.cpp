#include "render/colour/primaries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/colour/colour_space.h"
#include "render/colour/tristimulus.h"

namespace loomlight {
namespace {

LinearWeights plainWeights() {
  return linearWeights(illuminantNamed("D65"), Observer::degrees2);
}

TEST(ColourPrimaries, AreReflectancesThatTogetherAreWhite) {
  const Primaries& primaries = colourPrimaries();
  for (size_t j = 0; j < kBands; ++j) {
    float sum = 0;
    for (const Spectrum& primary : primaries) {
      EXPECT_GE(primary[j], 0) << j;
      sum += primary[j];
    }
    EXPECT_NEAR(sum, 1, 2e-7) << j;
  }
}

TEST(ColourPrimaries, GiveEveryColourBack) {
  const LinearWeights weights = plainWeights();
  std::mt19937 random(18);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 100; ++i) {
    const Rgb colour(unit(random), unit(random), unit(random));
    const glm::dvec3 seen = weighted(weights, mixed(colourPrimaries(), colour));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], colour[c], 1e-6);
  }
}

/// A slip in a digit of the table would be a jump.
TEST(ColourPrimaries, StepGentlyFromBandToBand) {
  for (const Spectrum& primary : colourPrimaries())
    for (size_t j = 1; j < kBands; ++j) EXPECT_LT(std::abs(primary[j] - primary[j - 1]), 0.27f) << j;
}

TEST(DaylightPrimaries, GiveEveryColourBackAndWhiteIsD65) {
  const LinearWeights weights = plainWeights();
  for (const Rgb& colour : {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1), Rgb(0.2f, 0.5f, 1)}) {
    const glm::dvec3 seen = weighted(weights, mixed(daylightPrimaries(), colour));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], colour[c], 2e-6);
  }
  for (const float power : mixed(daylightPrimaries(), Rgb(1))) EXPECT_NEAR(power, 1, 1e-5);
}

/// The CIE's own daylight of another temperature is the mixture of its colour.
TEST(DaylightPrimaries, MixDaylightOfAnotherTemperature) {
  const Illuminant d50 = illuminantNamed("D50"), d65 = illuminantNamed("D65");
  Spectrum relative;
  for (size_t j = 0; j < kBands; ++j) {
    const int i = bandWavelength_nm(j) - kFirstVisible_nm;
    relative[j] = static_cast<float>(d50.power[i] / d65.power[i]);
  }
  const Spectrum lifted = mixed(daylightPrimaries(), Rgb(weighted(plainWeights(), relative)));
  for (size_t j = 0; j < kBands; ++j) EXPECT_NEAR(lifted[j], relative[j], 1e-4);
}

}  // namespace
}  // namespace loomlight
