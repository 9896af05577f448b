#include "render/colour/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loomlight {
namespace {

TEST(BlackBodyTint, LeavesLightOf6500KelvinAsItIs) {
  EXPECT_EQ(blackBodyTint(6500), Rgb(1));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(blackBodyTint(6501)[c], 1, 1e-3);
}

TEST(BlackBodyTint, GrowsFromRedToBlueAtEqualLuminance) {
  float last = 0;
  for (double kelvin = 2000; kelvin <= 12000; kelvin += 250) {
    const Rgb tint = blackBodyTint(kelvin);
    EXPECT_NEAR(glm::dot(tint, Rgb(0.2126f, 0.7152f, 0.0722f)), 1, 1e-6) << kelvin;
    EXPECT_GT(tint.b, 0) << kelvin;  // a dye divides by it
    EXPECT_GT(tint.b / tint.r, last) << kelvin;
    last = tint.b / tint.r;
  }
}

/// CIE illuminant A is a black body of 2856 K: x 0.44758, y 0.40745 (CIE 15:2004). The matching functions are fitted
/// ones, hence the tolerance.
TEST(Spectrum, OfABlackBodyHasTheColourOfIlluminantA) {
  glm::dvec3 xyz(0);
  for (double nm = 380; nm <= 780; nm += 1) xyz += planck(nm, 2856) * colourMatching(nm);
  const double sum = xyz.x + xyz.y + xyz.z;
  EXPECT_NEAR(xyz.x / sum, 0.44758, 0.003);
  EXPECT_NEAR(xyz.y / sum, 0.40745, 0.003);
}

TEST(Spectrum, DaylightWhiteIsWhite) {
  const Rgb white = rgbFromXyz({0.95047f, 1, 1.08883f});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 1e-4);
}

}  // namespace
}  // namespace loomlight
