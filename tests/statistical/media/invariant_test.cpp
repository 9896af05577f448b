#include <gtest/gtest.h>

#include "render/media/volume_medium.h"
#include "tests/support/isotropic_light.h"
#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

// Under isotropic light the mean number of events of an entering photon is lateral fibre area over boundary area,
// pi r (length per area) for a sheet, whatever the weave, the packing and the roughness (in a stationary radiance field
// every surface is hit in proportion to its area). It holds for lobes that conserve energy both ways, and unmasks a
// traversal that skips or repeats fibres.
TEST(EventCount, IsLateralFibreAreaOverBoundaryArea) {
  Fabric fabric = test::whiteCotton();
  fabric.drape.width_mm = fabric.drape.height_mm = 80;  // so that hardly any path finds the edge
  for (const double count_tex : {10.0, 25.0}) {
    fabric.yarns[0].count_tex = count_tex;
    const auto scene = test::sceneOf(fabric);
    const double expected = test::lateralOverBoundaryArea(*scene);
    const auto events = test::eventsUnderIsotropicLight(*scene, VolumeMedium(scene->cloth), 4, 4000, 7);
    EXPECT_NEAR(events.mean, expected, 3.3 * events.standardError + 0.01 * expected) << count_tex << " tex";
    EXPECT_LT(events.standardError, 0.05 * expected);
  }
}

}  // namespace
}  // namespace loomlight
