#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/fabric/model/choice_names.h"
#include "render/media/report_medium.h"
#include "render/media/volume_medium.h"
#include "render/optics/fibre_frame.h"
#include "render/transport/path_tracer.h"
#include "tests/support/every_sample.h"
#include "tests/support/mesh_drape.h"
#include "tests/support/sampled_mean.h"
#include "tests/support/test_cloth.h"
#include "tests/support/white_light.h"

namespace loomlight {
namespace {

// The report's mode does not keep the furnace, and says so: light that comes straight is seen through the BVDF, light
// that goes on through the volume. That is all it gains or loses: radiance 1 and E[V_bvdf - V_volume] at the first
// fibre, here with a BVDF that sees no shadow within the cell. The white light is looked for at every event.
struct Case {
  DrapeKind drape;
  int resolution;
};

class ReportFurnace : public testing::TestWithParam<Case> {};

TEST_P(ReportFurnace, IsOffByWhatDirectLightGainsAndNoMore) {
  const test::WhiteLight white;
  Fabric fabric = test::whiteCotton();
  fabric.drape.kind = GetParam().drape;
  fabric.render.resolution = GetParam().resolution;
  fabric.drape.radius_mm = 5;
  const test::MeshDrape saddle;
  if (fabric.drape.kind == DrapeKind::mesh) {
    saddle.giveTo(fabric);
    fabric.camera.distance_mm = 8;
  }
  white.shineOn(fabric);
  const auto scene = test::sceneOf(fabric);
  const BvdfResolution resolution{2, 2, 4, 4};
  auto open = std::make_shared<BvdfSet>();
  open->tables.emplace_back(resolution, HotSpot{5, 0.1f}, std::vector<float>(resolution.bins(), 0.0f));
  open->tableOfYarn = {0};
  const ReportMedium report(scene->cloth, open);
  const VolumeMedium plain(scene->cloth);
  const CameraRays camera(fabric.camera, 48, 48);
  constexpr auto kFar = std::numeric_limits<float>::infinity();
  TraceCounts counts;
  Random random(8);
  test::SampledMean radiance, gain;
  MediumPath path = report.path(), through = plain.path();
  test::forEachSample(*scene, report, camera, {0, 0, 48, 48}, 8, counts, [&](int x, int y, const PathSample& sample) {
    if (sample.alpha > 0) radiance.add(sample.direct.g + sample.indirect.g);

    const float dx = random.uniform(), dy = random.uniform();
    const Ray ray = camera.ray(static_cast<float>(x) + dx, static_cast<float>(y) + dy);
    path.begin({ray.origin, -1});
    const auto hit = path.collide(ray.direction, random, counts);
    if (!hit) return;
    const FibreFrame frame(hit->tangent);
    const auto scattered = scene->cloth->materials[0].bcsdf->sample(frame.toLocal(-ray.direction), hit->offset, random);
    const glm::vec3 on = frame.toWorld(scattered.wi);
    path.leave(*hit, on, scattered.length_radii);
    through.begin(path.place());
    gain.add(path.transmittance(on, kFar, random, counts) - through.transmittance(on, kFar, random, counts));
  });
  EXPECT_GT(gain.mean(), 0.03);
  const double error = std::hypot(radiance.standardError(), gain.standardError());
  EXPECT_LT(error, 0.006);
  EXPECT_TRUE(test::isWithinNoise(radiance.mean(), 1 + gain.mean(), error, 2));
}

INSTANTIATE_TEST_SUITE_P(OnADrape, ReportFurnace,
                         testing::Values(Case{DrapeKind::flat, 8}, Case{DrapeKind::flat, 4},
                                         Case{DrapeKind::cylinder, 8}, Case{DrapeKind::cylinder, 2},
                                         Case{DrapeKind::sphere, 8}, Case{DrapeKind::folds, 8},
                                         Case{DrapeKind::cushion, 4}, Case{DrapeKind::skirt, 8},
                                         Case{DrapeKind::mesh, 8}, Case{DrapeKind::flat, 1}, Case{DrapeKind::flat, 16}),
                         [](const testing::TestParamInfo<Case>& info) {
                           const auto drape = static_cast<size_t>(info.param.drape);
                           return std::string(ChoiceNames<DrapeKind>::names[drape]) + "_" +
                                  std::to_string(info.param.resolution);
                         });

}  // namespace
}  // namespace loomlight
