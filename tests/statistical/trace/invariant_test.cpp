#include <gtest/gtest.h>

#include <cmath>

#include "render/optics/fibre_frame.h"
#include "render/trace/volume_medium.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

/// Scattering events of one path through a sheet that never absorbs, entering at a point of its upper face.
uint64_t eventsOfPath(const Scene& scene, glm::vec3 origin, glm::vec3 direction, Random& random) {
  const VolumeMedium medium(scene);
  Departure from{{origin, -1}};
  TraceCounts counts;
  while (const auto collision = medium.collide(from, direction, random, counts)) {
    const FibreFrame frame(collision->tangent);
    const FibreBcsdf& bcsdf = *scene.materials[collision->optics.material].bcsdf;
    const auto scattered = bcsdf.sample(frame.toLocal(-direction), collision->offset, random);
    direction = frame.toWorld(scattered.wi);
    from = medium.leave(*collision, direction, scattered.order);
  }
  return counts.events;
}

// Under isotropic light the mean number of events of an entering photon is lateral fibre area over boundary area,
// pi r (length per area) for a sheet, whatever the weave, the packing and the roughness (appearance of a stationary
// radiance field: every surface is hit in proportion to its area). It holds for lobes that conserve energy both ways,
// and unmasks a traversal that skips or repeats fibres.
TEST(EventCount, IsLateralFibreAreaOverBoundaryArea) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.width_mm = fabric.drape.height_mm = 80;  // so that hardly any path finds the edge
  for (const double count_tex : {10.0, 25.0}) {
    fabric.yarns[0].count_tex = count_tex;
    const auto scene = test::sceneOf(fabric);
    const ClothMeasures measures = scene->volume->geometry().measure();
    const double massPerArea_g_mm2 = measures.arealMass_g_m2 * 1e-6;
    const double radius_mm = scene->yarns[0][0].fibreRadius_mm;
    const double density_g_mm3 = fabric.fibres[0].density_g_cm3 * 1e-3;
    const double expected = massPerArea_g_mm2 / (density_g_mm3 * radius_mm);

    Random random(7);
    constexpr int kPaths = 4000;
    double sum = 0, squares = 0;
    for (int i = 0; i < kPaths; ++i) {
      const float u = random.uniform(), v = random.uniform(), a = random.uniform(), b = random.uniform();
      const float sine = std::sqrt(a), phi = static_cast<float>(2 * kPi) * b;  // cosine-distributed: isotropic light
      const glm::vec3 d(sine * std::cos(phi), sine * std::sin(phi), -std::sqrt(1 - a));
      const auto z = static_cast<float>(scene->volume->geometry().halfThickness_mm());
      const double n = static_cast<double>(eventsOfPath(*scene, {8 * u - 4, 8 * v - 4, z + 1e-3f}, d, random));
      sum += n;
      squares += n * n;
    }
    const double mean = sum / kPaths;
    const double standardError = std::sqrt((squares / kPaths - mean * mean) / kPaths);
    EXPECT_NEAR(mean, expected, 3.3 * standardError + 0.01 * expected) << count_tex << " tex";
    EXPECT_LT(standardError, 0.05 * expected);
  }
}

}  // namespace
}  // namespace loomlight
