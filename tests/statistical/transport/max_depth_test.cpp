#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/every_medium.h"
#include "tests/support/every_sample.h"
#include "tests/support/sampled_mean.h"
#include "tests/support/test_cloth.h"
#include "tests/support/white_light.h"

namespace loomlight {
namespace {

/// Where paths end is no matter of how their light is found: whether lamps are looked for, or paths come upon them.
TEST(MaxDepth, IsTheSameHoweverLightIsFound) {
  const test::WhiteLight white;
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].count_tex = 10;
  fabric.drape.width_mm = fabric.drape.height_mm = 3;
  fabric.camera.distance_mm = 5;
  fabric.render.resolution = 4;
  white.shineOn(fabric);
  test::kLoomlight.askFor(fabric);
  for (const int depth : {1, 2}) {
    fabric.render.maxDepth = depth;
    const auto scene = test::sceneOf(fabric);
    ASSERT_TRUE(scene->lighting->wantsSampling());
    const auto medium = test::kLoomlight.make(*scene);
    const auto radianceOf = [&](bool lamps) {
      Scene sampled = *scene;
      sampled.sampling.lamps = lamps;
      test::SampledMean radiance;
      test::forEachSample(sampled, *medium, 32, 16, [&](int, int, const PathSample& sample) {
        if (sample.alpha > 0) radiance.add(sample.direct.g + sample.indirect.g);
      });
      return radiance;
    };
    const test::SampledMean byLamps = radianceOf(true), byChance = radianceOf(false);
    EXPECT_LT(byChance.mean(), 0.95) << "the limit is felt";
    EXPECT_TRUE(test::isWithinNoise(byLamps.mean(), byChance.mean(),
                                    std::hypot(byLamps.standardError(), byChance.standardError()), 2))
        << "at " << depth;
  }
}

}  // namespace
}  // namespace loomlight
