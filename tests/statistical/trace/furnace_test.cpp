#include <gtest/gtest.h>

#include "render/trace/path_tracer.h"
#include "render/trace/volume_medium.h"
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
// single path returns exactly 1, unless it was cut at the depth limit, so there is no noise to allow for: 0.3 % is for
// paths that long.
TEST(WhiteFurnace, FlatClothIsInvisible) {
  const Furnace f = renderFurnace(test::whiteCotton());
  EXPECT_GT(f.alpha, 0.5);
  EXPECT_NEAR(f.radiance / f.alpha, 1.0, 0.003);
}

TEST(WhiteFurnace, ReportsEventLawIsInvisibleToo) {
  Fabric fabric = test::whiteCotton();
  fabric.render.eventLaw = EventLaw::report;
  const Furnace f = renderFurnace(fabric);
  EXPECT_NEAR(f.radiance / f.alpha, 1.0, 0.003);
}

TEST(WhiteFurnace, BentClothIsInvisible) {
  for (const DrapeKind kind : {DrapeKind::cylinder, DrapeKind::sphere}) {
    Fabric fabric = test::whiteCotton();
    fabric.drape.kind = kind;
    fabric.drape.radius_mm = 5;
    const Furnace f = renderFurnace(fabric);
    EXPECT_GT(f.alpha, 0.1);
    EXPECT_NEAR(f.radiance / f.alpha, 1.0, 0.003);
  }
}

TEST(WhiteFurnace, EveryResolutionIsInvisible) {
  for (const int resolution : {1, 2, 4, 16}) {
    Fabric fabric = test::whiteCotton();
    fabric.render.resolution = resolution;
    const Furnace f = renderFurnace(fabric, 16, 4);
    EXPECT_NEAR(f.radiance / f.alpha, 1.0, 0.003) << resolution;
  }
}

// Light sampling and BCSDF sampling together (MIS) estimate what BCSDF sampling alone does: a lat-long sky seen with
// and without next-event estimation is covered by the light's own tests; here a dyed cloth under a dome must be darker
// than the furnace and brighter than its surface reflection alone.
TEST(Dome, DyedClothKeepsBetweenReflectionAndWhite) {
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
