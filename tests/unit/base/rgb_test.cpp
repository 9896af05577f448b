#include "core/base/rgb.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

TEST(Srgb, IsAsTheStandardHasItThereAndBack) {
  EXPECT_NEAR(linearFromSrgb(Rgb(0.5f)).r, 0.21404f, 1e-5f);
  for (const float c : {0.0f, 0.01f, 0.04f, 0.2f, 1.0f})
    EXPECT_NEAR(srgbFromLinear(linearFromSrgb(Rgb(c))).r, c, 1e-6f);
}

// White is as bright as its channels; green is the brightest of the primaries, and the same in single precision.
TEST(Luminance, IsThatOfRec709) {
  EXPECT_FLOAT_EQ(luminance(Rgb(0.25f)), 0.25f);
  EXPECT_DOUBLE_EQ(luminance(glm::dvec3(1, 0, 0)), 0.2126);
  EXPECT_DOUBLE_EQ(luminance(glm::dvec3(0, 1, 0)), 0.7152);
  EXPECT_DOUBLE_EQ(luminance(glm::dvec3(0, 0, 1)), 0.0722);
  EXPECT_EQ(luminance(Rgb(0, 1, 0)), 0.7152f);
}

}  // namespace
}  // namespace loomlight
