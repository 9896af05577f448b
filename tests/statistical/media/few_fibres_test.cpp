#include <gtest/gtest.h>

#include <cmath>

#include "render/media/fibre_medium.h"
#include "render/optics/fibre_frame.h"
#include "render/scene/fibre_bvh.h"
#include "render/transport/path_tracer.h"
#include "tests/support/any_direction.h"
#include "tests/support/every_sample.h"
#include "tests/support/fibre_oracle.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// One end and one pick, each of a single fibre 0.1 mm thick, which touch in the middle of 5 x 5 mm.
Fabric crossedFibres() {
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].fibresPerPly = 1;
  fabric.yarns[0].flattening = 1;
  fabric.yarns[0].plyTwist_per_m = 0;
  fabric.yarns[0].layout = FibreLayout::random;
  fabric.fibres[0].radius_um = 50;
  fabric.ends_per_cm = fabric.picks_per_cm = 2;
  fabric.drape.width_mm = fabric.drape.height_mm = 5;
  fabric.render.resolution = 1;
  return fabric;
}

constexpr float kFar = 1e9f;

bool agree(const std::optional<FibreHit>& hit, const std::optional<test::FibreOracle::Hit>& expected,
           glm::vec3 direction) {
  if (!hit || !expected) return !hit && !expected;
  const test::FibreOracle::Segment& segment = *expected->segment;
  const glm::vec3 across = glm::normalize(glm::cross(hit->tangent, direction));
  return hit->system == segment.system && std::abs(hit->distance_mm - expected->distance) < 0.01 * segment.radius &&
         glm::dot(glm::dvec3(hit->tangent), segment.tangent()) > 0.999 &&
         std::abs(glm::dot(across, hit->normal) - expected->offset) < 0.02;
}

class FewFibres : public testing::Test {
 protected:
  explicit FewFibres(const Fabric& fabric = crossedFibres()) : scene(test::sceneOf(fabric)) {}

  /// The end's segment at a height of the picture, far from the pick.
  const test::FibreOracle::Segment& warpAt(double y) const {
    for (const auto& s : oracle.segments())
      if (s.system == System::warp && std::min(s.a.y, s.b.y) <= y && std::max(s.a.y, s.b.y) > y) return s;
    throw std::logic_error("no end there");
  }

  std::shared_ptr<const Scene> scene;
  test::FibreOracle oracle{*scene};
  std::unique_ptr<const FibreBvh> bvh = FibreBvh::build(scene->cloth, planFibres(*scene->cloth, {}), Task{});
};

// Parallel rays, evenly spaced across a fibre: the share 2 r / width of them meets it, and the one that passes at h r
// from the axis has the offset h, so that h is uniform.
TEST_F(FewFibres, OneIsMetOverItsWidthAtEvenOffsets) {
  const auto& fibre = warpAt(1.5);
  const glm::dvec3 middle = 0.5 * (fibre.a + fibre.b);
  for (const glm::dvec3 from : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0.2, 0.3), glm::dvec3(-0.5, 1.5, 0.6)}) {
    const glm::dvec3 direction = -glm::normalize(from);
    const glm::dvec3 across = glm::normalize(glm::cross(fibre.tangent(), direction));
    constexpr int kRays = 4000;
    const double width = 5 * fibre.radius;
    int met = 0;
    for (int i = 0; i < kRays; ++i) {
      const double aside = ((i + 0.5) / kRays - 0.5) * width;
      const auto hit = bvh->meet({glm::vec3(middle + aside * across - 0.5 * direction), glm::vec3(direction)});
      if (!hit) continue;
      ++met;
      const double h = glm::dot(glm::cross(glm::dvec3(hit->tangent), direction), glm::dvec3(hit->normal)) /
                       glm::length(glm::cross(glm::dvec3(hit->tangent), direction));
      ASSERT_NEAR(h, aside / fibre.radius, 2e-3);
      ASSERT_EQ(hit->system, System::warp);
    }
    EXPECT_NEAR(static_cast<double>(met) / kRays, 2 * fibre.radius / width, 2.0 / kRays);
  }
}

// What the tracer makes of one fibre in parallel light is the integral of its BCSDF over the width, coloured by what
// each mode passes through.
TEST_F(FewFibres, OneShowsTheIntegralOfItsBcsdfInParallelLight) {
  for (const double elevation_deg : {60.0, -50.0}) {  // reflected, and through the fibre
    Fabric fabric = crossedFibres();
    fabric.fibres[0].absorption_per_mm = Rgb(1, 5, 20);
    fabric.light.kind = LightKind::directional;
    fabric.light.azimuth_deg = 30;
    fabric.light.elevation_deg = elevation_deg;
    fabric.render.maxDepth = 1;
    fabric.camera.elevation_deg = 90;
    fabric.camera.fov_deg = 0;
    fabric.camera.distance_mm = 1;
    fabric.camera.target_mm = {0, 1.5, 0};
    const auto lit = test::sceneOf(fabric);
    const auto fibres = FibreMedium::build(lit->cloth, {}, Task{});
    constexpr int kSide = 48;
    constexpr uint32_t kSamples = 24;
    glm::dvec3 sum(0), squares(0);
    test::forEachSample(*lit, *fibres, kSide, kSamples, [&](int, int, const PathSample& sample) {
      const glm::dvec3 value(sample.direct);
      sum += value;
      squares += value * value;
    });
    constexpr double kPaths = double{kSide} * kSide * kSamples;
    const glm::dvec3 mean = sum / kPaths, error = glm::sqrt((squares / kPaths - mean * mean) / kPaths);

    const auto& fibre = warpAt(1.5);
    const FibreFrame frame(glm::vec3(fibre.tangent()));
    Random random(1);
    const auto light = lit->lighting->sample(glm::vec3(fibre.a), random);
    ASSERT_TRUE(light && light->isDelta());
    const Material& material = lit->cloth->materials[0];
    glm::dvec3 scattered(0);
    constexpr int kOffsets = 2000;
    for (int i = 0; i < kOffsets; ++i) {
      const auto h = static_cast<float>(2 * (i + 0.5) / kOffsets - 1);
      const auto value = material.bcsdf->evaluate(frame.toLocal({0, 0, 1}), frame.toLocal(light->wi), h);
      for (int c = 0; c < 3; ++c) {
        const double t = std::exp(-lit->colouring.primaries_per_mm[0][c] * value.chord_radii * fibre.radius),
                     inside = value.internalReflectance;
        // Mode p passes p times; of the residual each further pass keeps the share that stays inside.
        double through = value.q[0] + value.q[1] * t + value.q[2] * t * t, share = 1 - inside, passed = t * t * t;
        for (int p = 3; p < 60; ++p, share *= inside, passed *= t) through += value.q[3] * share * passed;
        scattered[c] += through / kOffsets;
      }
    }
    const double shown_mm = 2 * std::tan(10 * kPi / 180) * fabric.camera.distance_mm;
    const glm::dvec3 expected =
        scattered * glm::dvec3(lit->lighting->radiance(*light)) / double{light->pdf} * 2.0 * fibre.radius / shown_mm;
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(mean[c], expected[c], 4 * error[c]) << elevation_deg;
      EXPECT_LT(error[c], 0.02 * expected[c]);
    }
  }
}

// Rays from outside, and on from fibre to fibre, meet what a search over all segments meets: the same fibre at the same
// distance and offset, and shadow rays see as far. Left out are rays within a thousandth of a radius of a silhouette,
// or that start as near to another surface: rounding decides those. Embree closes the joints of its curves nearly, not
// quite: one ray in a thousand or two slips or stops there.
TEST_F(FewFibres, CrossedOnesAreMetAsASearchOverAllMeetsThem) {
  constexpr double kDelicate = 1e-3, kAtJoints = 2e-3;
  Random random(5);
  int rays = 0, first = 0, again = 0, delicate = 0, otherwise = 0;
  for (int i = 0; i < 20000; ++i) {
    const float u = random.uniform(), v = random.uniform();
    glm::vec3 direction = test::anyDirection(random);
    glm::vec3 origin = glm::vec3(0.3f * (u - 0.5f), 0.3f * (v - 0.5f), 0) - 2.0f * direction;
    const test::FibreOracle::Segment* own = nullptr;
    uint64_t ownFibre = 0;
    for (int flight = 0; flight < 4; ++flight) {
      const float clearance = own ? static_cast<float>(3 * own->radius) : 0;
      const auto length = 0.5f * random.uniform();
      const auto expected = oracle.meet(origin, direction, kFar, own, clearance);
      const auto hit = bvh->meet({origin, direction, kFar, ownFibre, clearance});
      const bool free = bvh->isFree({origin, direction, length, ownFibre, clearance});
      if (oracle.isDelicate(origin, direction, own, kDelicate)) {
        ++delicate;
        break;
      }
      ++rays;
      if (!agree(hit, expected, direction) || free != (!expected || expected->distance > length)) {
        ++otherwise;
        break;
      }
      if (!hit) break;
      ++(own ? again : first);
      origin += hit->distance_mm * direction;
      direction = test::anyDirection(random);
      own = expected->segment;
      ownFibre = hit->fibre;
    }
  }
  EXPECT_GT(first, 10000);
  EXPECT_GT(again, 1000);
  EXPECT_LT(delicate, 0.05 * rays);
  EXPECT_LT(otherwise, kAtJoints * rays);
}

}  // namespace
}  // namespace loomlight
