#include "render/media/loomlight_medium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/media/fibre_medium.h"
#include "render/media/volume_medium.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_sample.h"
#include "tests/support/isotropic_light.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Round yarns of 100 packed fibres in an open plain weave: fibres can be told from voxels here.
Fabric openWeave() {
  Fabric fabric = test::whiteCotton();
  Yarn& yarn = fabric.yarns[0];
  yarn.fibresPerPly = 100;
  yarn.packing = 0.5;
  yarn.flattening = 1;
  fabric.fibres[0].radius_um = 6.5;
  fabric.ends_per_cm = fabric.picks_per_cm = 31;
  fabric.drape.width_mm = fabric.drape.height_mm = 8;
  fabric.camera.distance_mm = 12;
  fabric.camera.elevation_deg = 75;
  return fabric;
}

struct MeanRadiance {
  double radiance = 0, alpha = 0, standardError = 0;
};

MeanRadiance render(const Scene& scene, const Medium& medium, int side, uint32_t samples) {
  const double paths = static_cast<double>(side) * side * samples;
  double sum = 0, squares = 0, alpha = 0;
  test::forEachSample(scene, medium, side, samples, [&](int, int, const PathSample& sample) {
    const double value = sample.direct.g + sample.indirect.g;
    sum += value;
    squares += value * value;
    alpha += sample.alpha;
  });
  const double mean = sum / paths;
  return {mean, alpha / paths, std::sqrt((squares / paths - mean * mean) / paths)};
}

TEST(LoomlightMedium, SeesNoShadowWithTheLightBehindTheEye) {
  // What the eye sees, a lamp at the eye sees too: light that the surface mirrors straight back has met nothing on the
  // way in, so it meets nothing on the way out. The plain volume has forgotten.
  Fabric fabric = openWeave();
  const auto scene = test::sceneOf(fabric);
  const LoomlightMedium loomlight(scene->cloth);
  const VolumeMedium plain(scene->cloth);
  const CameraRays camera(fabric.camera, 32, 32);
  Random random(2);
  TraceCounts counts;
  double visible[2] = {0, 0}, hits[2] = {0, 0};
  MediumPath paths[2] = {loomlight.path(), plain.path()};
  for (int i = 0; i < 4000; ++i) {
    const float x = 32 * random.uniform(), y = 32 * random.uniform();
    const Ray ray = camera.ray(x, y);
    for (int m = 0; m < 2; ++m) {
      paths[m].begin({ray.origin, -1});
      if (const auto hit = paths[m].collide(ray.direction, random, counts)) {
        paths[m].leave(*hit, -ray.direction, 0);
        const float t = paths[m].transmittance(-ray.direction, hit->distance_mm, random, counts);
        if (m == 0) {
          ASSERT_GT(t, 0.999f);
        }
        visible[m] += t;
        ++hits[m];
      }
    }
  }
  EXPECT_GT(hits[0], 1000);
  EXPECT_LT(visible[1] / hits[1], 0.7);  // one half in a half-space (Lommel-Seeliger)
}

// Lateral fibre area over boundary area, however the fibres are told. Packing without its exits, or exits without
// packing, would be off by tens of percent.
TEST(LoomlightMedium, EventCountIsLateralAreaOverBoundaryArea) {
  const auto scene = test::sceneOf(openWeave());
  const double expected = test::lateralOverBoundaryArea(*scene);
  const auto [mean, error] = test::eventsUnderIsotropicLight(*scene, LoomlightMedium(scene->cloth), 1, 60000, 5);
  EXPECT_LT(error, 0.005 * expected);
  EXPECT_NEAR(mean, expected, 0.03 * expected + 2 * error);
}

// The claim itself, in small: dyed cloth under a white dome, seen from above, against its own fibres. The plain volume
// is too dark because light at a surface forgets that it came from outside.
TEST(LoomlightMedium, IsNearerToTheFibresThanThePlainVolume) {
  Fabric fabric = openWeave();
  fabric.fibres[0].absorption_per_mm = Rgb(12.0f);
  fabric.light.kind = LightKind::dome;
  fabric.camera.elevation_deg = 90;
  fabric.camera.distance_mm = 8;
  const auto scene = test::sceneOf(fabric);
  const auto fibres = FibreMedium::build(scene->cloth, 4e9, Task{});
  const MeanRadiance truth = render(*scene, *fibres, 48, 24);
  const MeanRadiance ours = render(*scene, LoomlightMedium(scene->cloth), 48, 24);
  const MeanRadiance plain = render(*scene, VolumeMedium(scene->cloth), 48, 24);
  const double noise = 3 * truth.standardError / truth.radiance;
  EXPECT_LT(std::abs(ours.radiance / truth.radiance - 1), 0.05 + noise);
  EXPECT_LT(std::abs(ours.radiance / truth.radiance - 1), std::abs(plain.radiance / truth.radiance - 1));
  RecordProperty("ours", std::to_string(ours.radiance / truth.radiance));
  RecordProperty("plain", std::to_string(plain.radiance / truth.radiance));
}

}  // namespace
}  // namespace loomlight
