#include "core/fabric/yarn/colour.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(Colour, AbsorptionIsThatOfChiang) {
  // Reflectance of a thick mass at beta_n 0.3: 0.555, 0.268, 0.155 for absorption * radius of 0.01, 0.05, 0.1.
  const double radius_um = 6.0;
  const Rgb absorption = Rgb(0.01f, 0.05f, 0.1f) / static_cast<float>(radius_um * kMmPerUm);
  const Rgb colour = colourFromAbsorption(absorption, 0.3, radius_um);
  EXPECT_NEAR(colour.r, 0.555, 0.001);
  EXPECT_NEAR(colour.g, 0.268, 0.001);
  EXPECT_NEAR(colour.b, 0.155, 0.001);
}

TEST(Colour, AbsorptionAndColourInvertEachOther) {
  for (const double beta : {0.05, 0.3, 1.0})
    for (const double radius : {1.0, 6.5, 200.0})
      for (const float c : {0.001f, 0.02f, 0.5f, 0.97f}) {
        const Rgb back = colourFromAbsorption(absorptionFromColour(Rgb(c), beta, radius), beta, radius);
        EXPECT_NEAR(back.r / c, 1.0, 1e-4) << beta << " " << radius << " " << c;
      }
}

TEST(Colour, WhiteIsClearAndNothingIsInfinite) {
  EXPECT_EQ(absorptionFromColour(Rgb(1.0f), 0.3, 6.0), Rgb(0.0f));
  EXPECT_EQ(absorptionFromColour(Rgb(1.5f), 0.3, 6.0), Rgb(0.0f)) << "no fibre gives light";
  const Rgb black = absorptionFromColour(Rgb(0.0f), 0.3, 6.0);
  EXPECT_GT(black.r, 100.0f);
  EXPECT_LE(black.r, 10000.0f);
}

TEST(Colour, ThickerFibresNeedLessDye) {
  const Rgb thin = absorptionFromColour(Rgb(0.3f), 0.3, 5.0);
  const Rgb thick = absorptionFromColour(Rgb(0.3f), 0.3, 10.0);
  EXPECT_NEAR(thin.r, 2 * thick.r, 1e-4 * thin.r);
}

}  // namespace
}  // namespace loomlight
