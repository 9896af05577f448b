#include <gtest/gtest.h>

#include "app/workers/refinement.h"
#include "render/trace/make_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

constexpr int kWidth = 60, kHeight = 44;

class RecolourFade : public testing::Test {
 protected:
  static Traceable makeCloth() {
    Fabric fabric = test::whiteCotton();
    fabric.render.resolution = 2;
    fabric.drape.width_mm = fabric.drape.height_mm = 6;
    fabric.camera.distance_mm = 8;
    Traceable made;
    made.scene = made.mediumScene = test::sceneOf(fabric);
    made.medium = makeMedium(*made.scene, 1e9, Task{});
    return made;
  }
  static void refine(Refinement& refinement, uint32_t samples) {
    while (refinement.samples() < samples) ASSERT_TRUE(refinement.advance(Task{{}, {}, 1}));
  }
  const Traceable cloth = makeCloth();
};

// While a picture still has a share of an earlier one, that share is recoloured with it: nothing leaps.
TEST_F(RecolourFade, KeepsTheShareOfTheEarlierPicture) {
  Refinement earlier(cloth, kWidth, kHeight, 0);
  refine(earlier, 64);
  Refinement picture(cloth, kWidth, kHeight, 0);
  picture.keepPaths(size_t{64} << 20);
  picture.standIn(std::make_shared<const Frame>(earlier.frame()));
  picture.skipCoarse();
  refine(picture, 1);
  ASSERT_TRUE(picture.fading());
  EXPECT_EQ(picture.worth_samples(), 64u);
  const Frame before = picture.frame();
  for (const float brighter : {1.0f, 2.0f}) {
    double variance = 0;
    const Frame after = picture.recoloured({cloth.scene->absorption_per_mm, Rgb(brighter)}, 1, variance);
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
