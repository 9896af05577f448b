#include <gtest/gtest.h>

#include "tests/support/refining_test.h"

namespace loomlight {
namespace {

class RecolourFade : public test::RefiningTest {};

// While a picture still has a share of an earlier one, that share is recoloured with it: nothing leaps.
TEST_F(RecolourFade, KeepsTheShareOfTheEarlierPicture) {
  Refinement earlier(cloth, kWidth, kHeight, {});
  refine(earlier, 64);
  Refinement picture(cloth, kWidth, kHeight, {.paths_bytes = size_t{64} << 20});
  picture.standIn(std::make_shared<const Frame>(earlier.frame()));
  picture.skipCoarse();
  refine(picture, 1);
  ASSERT_TRUE(picture.fading());
  EXPECT_EQ(picture.worth_samples(), 64u);
  const Frame before = picture.frame();
  for (const float brighter : {1.0f, 2.0f}) {
    double variance = 0;
    const Frame after = picture.recoloured({cloth.scene->colouring, Rgb(brighter)}, 1, variance);
    EXPECT_EQ(after.samples, before.samples);
    for (size_t i = 0; i < after.rgba.size(); ++i)
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_NEAR(after.rgba[i][channel], brighter * before.rgba[i][channel],
                    1e-3 * brighter * (0.01 + before.rgba[i][channel]))
            << i;
  }
}

}  // namespace
}  // namespace loomlight
