#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/media/report_medium.h"
#include "render/optics/fibre_frame.h"
#include "render/transport/path_tracer.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

struct Mean {
  double sum = 0, squares = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double value() const { return sum / count; }
  double standardError() const { return std::sqrt((squares / count - value() * value()) / count); }
};

// The report's mode does not keep the furnace, and says so: light that comes straight is seen through the BVDF, light
// that goes on through the volume. That is all it gains or loses: radiance 1 and E[V_bvdf - V_volume] at the first
// fibre, here with a BVDF that sees no shadow within the cell.
TEST(ReportMedium, FurnaceIsOffByWhatDirectLightGainsAndNoMore) {
  Fabric fabric = test::whiteCotton();
  fabric.light.kind = LightKind::furnace;
  const auto scene = test::sceneOf(fabric);
  const BvdfResolution resolution{2, 2, 4, 4};
  auto open = std::make_shared<BvdfSet>();
  open->tables.emplace_back(resolution, HotSpot{5, 0.1f}, std::vector<float>(resolution.bins(), 0.0f));
  open->tableOfYarn = {0};
  const ReportMedium report(*scene, open);
  const VolumeMedium plain(*scene);
  const CameraRays camera(fabric.camera, 48, 48);
  constexpr auto kFar = std::numeric_limits<float>::infinity();
  TraceCounts counts;
  Random random(8);
  Mean radiance, gain;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      for (uint32_t i = 0; i < 8; ++i) {
        const PathSample sample = tracePath(*scene, report, camera, x, y, i, counts);
        if (sample.alpha > 0) radiance.add(sample.direct.g + sample.indirect.g);

        const float dx = random.uniform(), dy = random.uniform();
        const Ray ray = camera.ray(static_cast<float>(x) + dx, static_cast<float>(y) + dy);
        const auto hit = report.collide({{ray.origin, -1}}, ray.direction, random, counts);
        if (!hit) continue;
        const FibreFrame frame(hit->tangent);
        const auto scattered = scene->materials[0].bcsdf->sample(frame.toLocal(-ray.direction), hit->offset, random);
        const glm::vec3 on = frame.toWorld(scattered.wi);
        const Departure from = report.leave(*hit, on, scattered.order);
        gain.add(report.transmittance(from, on, kFar, random, counts) -
                 plain.transmittance(from, on, kFar, random, counts));
      }
  EXPECT_GT(gain.value(), 0.03);
  EXPECT_NEAR(radiance.value(), 1 + gain.value(), 3.3 * std::hypot(radiance.standardError(), gain.standardError()));
  EXPECT_LT(radiance.standardError(), 0.01);
}

}  // namespace
}  // namespace loomlight
