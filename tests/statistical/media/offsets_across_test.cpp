#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "render/media/loomlight_medium.h"
#include "render/media/volume_medium.h"
#include "render/optics/fibre_frame.h"
#include "render/transport/path_integrator.h"
#include "tests/support/sampled_mean.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

using test::SampledMean;

/// How the mean over all offsets of a collision differs from what is at the offset that was met.
struct Outcome {
  SampledMean offset, square, light;
  double offsets = 0, collisions = 0;
};

/// Follows paths of white light through the cloth, and compares at each of their collisions what its offsets say with
/// what the one that was met says: of h, of its square, and of the light that a given lamp
/// brings to the path.
template <class M>
Outcome compare(const Scene& scene, const M& medium, int paths) {
  const CameraRays camera(scene.fabric->camera, 64, 64);
  const glm::vec3 lamp = glm::normalize(glm::vec3(0.4f, 0.3f, 0.9f));
  MediumPath path = medium.path();
  Random random(7);
  TraceCounts counts;
  Outcome outcome;
  for (int i = 0; i < paths; ++i) {
    const float x = 64 * random.uniform(), y = 64 * random.uniform();
    const Ray ray = camera.ray(x, y);
    path.begin({ray.origin, -1});
    glm::vec3 direction = ray.direction;
    for (int event = 0; event < 6; ++event) {
      const auto met = path.collide(direction, random, counts);
      if (!met) break;
      const FibreBcsdf& bcsdf = *scene.cloth->materials[static_cast<size_t>(met->material)].bcsdf;
      const FibreFrame frame(met->tangent);
      const glm::vec3 wo = frame.toLocal(-direction), wi = frame.toLocal(lamp);
      std::array<float, 6> offsets;
      const size_t count = path.offsetsAcross(*met, offsets, random);
      EXPECT_GE(count, 1u);
      EXPECT_EQ(offsets[0], met->offset);
      double mean = 0, square = 0, light = 0;
      for (size_t k = 0; k < count; ++k) {
        EXPECT_LE(std::abs(offsets[k]), 1);
        mean += offsets[k] / static_cast<double>(count);
        square += offsets[k] * offsets[k] / static_cast<double>(count);
        light += bcsdf.evaluate(wo, wi, offsets[k]).sum() / static_cast<double>(count);
      }
      // Signed by which side of the ray the fibre's upper end is on, or both signs would cancel.
      const double side = glm::dot(glm::cross(met->tangent, direction), met->normal) < 0 ? -1 : 1;
      outcome.offset.add(side * (mean - met->offset));
      outcome.square.add(square - met->offset * met->offset);
      outcome.light.add(light - bcsdf.evaluate(wo, wi, met->offset).sum());
      outcome.offsets += static_cast<double>(count);
      ++outcome.collisions;
      const auto scattered = bcsdf.sample(wo, met->offset, random);
      direction = frame.toWorld(scattered.wi);
      path.leave(*met, direction, scattered.length_radii);
    }
  }
  return outcome;
}

/// Dense and open, flat and bent, packed and laid at random: points across the fibre lead out of its voxel, and out of
/// its yarn.
std::vector<Fabric> cloths() {
  std::vector<Fabric> all;
  for (const DrapeKind drape : {DrapeKind::flat, DrapeKind::cylinder})
    for (const FibreLayout layout : {FibreLayout::packed, FibreLayout::random}) {
      Fabric fabric = test::whiteCotton();
      fabric.yarns[0].layout = layout;
      fabric.drape.kind = drape;
      all.push_back(fabric);
    }
  return all;
}

void expectNoDifference(const Outcome& outcome) {
  for (const SampledMean& difference : {outcome.offset, outcome.square, outcome.light})
    EXPECT_TRUE(test::isWithinNoise(difference.mean(), 0, difference.standardError(), 15));
}

TEST(OffsetsAcross, HaveTheMeanOfTheOneThatIsMet) {
  for (const Fabric& fabric : cloths()) {
    const auto scene = test::sceneOf(fabric);
    const Outcome all = compare(*scene, LoomlightMedium(scene->cloth), 30000);
    EXPECT_GT(all.collisions, 40000);
    EXPECT_GT(all.offsets, 1.7 * all.collisions);  // enough of them have several for all this to say something
    expectNoDifference(all);
  }
}

TEST(OffsetsAcross, AreEvenWhereFibresArePoints) {
  const auto scene = test::sceneOf(test::whiteCotton());
  const Outcome all = compare(*scene, VolumeMedium(scene->cloth), 20000);
  EXPECT_EQ(all.offsets, 6 * all.collisions);
  expectNoDifference(all);
}

}  // namespace
}  // namespace loomlight
