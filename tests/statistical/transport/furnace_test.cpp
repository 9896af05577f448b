#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "render/film/image.h"
#include "render/media/volume_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Mean radiance and mean alpha of a picture, over paths.
struct Furnace {
  double radiance = 0, alpha = 0;
};

Furnace renderFurnace(Fabric fabric, int side = 24, uint32_t samples = 8) {
  fabric.light.kind = LightKind::furnace;
  const auto scene = test::sceneOf(fabric);
  const CameraRays camera(fabric.camera, side, side);
  const VolumeMedium medium(*scene);
  TraceCounts counts;
  Furnace mean;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (uint32_t i = 0; i < samples; ++i) {
        const PathSample sample = tracePath(*scene, medium, camera, x, y, i, counts);
        mean.radiance += (sample.direct.g + sample.indirect.g) / (side * side * samples);
        mean.alpha += static_cast<double>(sample.alpha) / (side * side * samples);
      }
  return mean;
}

// A white fabric under light of radiance 1 from everywhere has radiance 1 wherever there is a fibre: invariant 7. Every
// single path returns exactly 1, unless it was cut at the depth limit, so there is no noise to allow for: 0.1 % is for
// paths that long.
TEST(WhiteFurnace, FlatClothIsInvisible) {
  const Furnace f = renderFurnace(test::whiteCotton());
  EXPECT_GT(f.alpha, 0.5);
  EXPECT_NEAR(f.radiance / f.alpha, 1.0, 0.001);
}

TEST(WhiteFurnace, ReportsEventLawIsInvisibleToo) {
  Fabric fabric = test::whiteCotton();
  fabric.render.eventLaw = EventLaw::report;
  const Furnace f = renderFurnace(fabric);
  EXPECT_NEAR(f.radiance / f.alpha, 1.0, 0.001);
}

TEST(WhiteFurnace, BentClothIsInvisible) {
  for (const DrapeKind kind : {DrapeKind::cylinder, DrapeKind::sphere}) {
    Fabric fabric = test::whiteCotton();
    fabric.drape.kind = kind;
    fabric.drape.radius_mm = 5;
    const Furnace f = renderFurnace(fabric);
    EXPECT_GT(f.alpha, 0.1);
    EXPECT_NEAR(f.radiance / f.alpha, 1.0, 0.001);
  }
}

TEST(WhiteFurnace, EveryResolutionIsInvisible) {
  for (const int resolution : {1, 2, 4, 16}) {
    Fabric fabric = test::whiteCotton();
    fabric.render.resolution = resolution;
    const Furnace f = renderFurnace(fabric, 16, 4);
    EXPECT_NEAR(f.radiance / f.alpha, 1.0, 0.001) << resolution;
  }
}

// Looking for lamps and letting paths escape, weighted against each other, must estimate what escaping alone does. A
// white environment is known to both ways: as a picture it is sampled, as the furnace it is not, and clear fibres under
// it are white whatever the share of either.
TEST(WhiteFurnace, SampledAsAPictureIsWhiteToo) {
  const std::string file = testing::TempDir() + "loomlight-white-" + std::to_string(getpid()) + ".exr";
  Image white;
  white.width = 16;
  white.height = 8;
  for (const char* name : {"R", "G", "B"}) std::fill_n(white.add(name).begin(), 16 * 8, 1.0f);
  writeExr(file, white);
  Fabric fabric = test::whiteCotton();
  fabric.light.kind = LightKind::environment;
  fabric.light.file = file;
  const auto scene = test::sceneOf(fabric);
  ASSERT_TRUE(scene->lighting->wantsSampling());
  const VolumeMedium medium(*scene);
  const CameraRays camera(fabric.camera, 48, 48);
  TraceCounts counts;
  double sum = 0, squares = 0, hits = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      for (uint32_t i = 0; i < 16; ++i) {
        const PathSample sample = tracePath(*scene, medium, camera, x, y, i, counts);
        if (sample.alpha == 0) continue;
        const double value = sample.direct.g + sample.indirect.g;
        sum += value;
        squares += value * value;
        ++hits;
      }
  const double mean = sum / hits, error = std::sqrt((squares / hits - mean * mean) / hits);
  EXPECT_LT(error, 0.01);
  EXPECT_NEAR(mean, 1.0, 3.3 * error);
}

// A dyed cloth in the furnace is darker than white, and brighter than its surface reflection alone.
TEST(WhiteFurnace, DyedClothKeepsBetweenReflectionAndWhite) {
  Fabric fabric = test::whiteCotton();
  fabric.fibres[0].absorption_per_mm = Rgb(5.0f, 20.0f, 200.0f);
  fabric.light.kind = LightKind::furnace;
  const auto scene = test::sceneOf(fabric);
  const CameraRays camera(fabric.camera, 16, 16);
  const VolumeMedium medium(*scene);
  TraceCounts counts;
  Rgb sum(0.0f);
  float alpha = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (uint32_t i = 0; i < 16; ++i) {
        const PathSample sample = tracePath(*scene, medium, camera, x, y, i, counts);
        sum += sample.direct + sample.indirect;
        alpha += sample.alpha;
      }
  const Rgb mean = sum / alpha;
  EXPECT_LT(mean.r, 1.0f);
  EXPECT_LT(mean.g, mean.r);
  EXPECT_LT(mean.b, mean.g);
  EXPECT_GT(mean.b, 0.005f);  // what the surfaces mirror, however dark the inside
}

}  // namespace
}  // namespace loomlight
