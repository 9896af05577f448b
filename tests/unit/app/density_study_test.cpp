#include "app/commands/density_study.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/test_cloth.h"

namespace loomlight {
namespace {

Fabric twoPly() {
  Fabric fabric = test::whiteCotton();
  fabric.yarns[0].plies = 2;
  fabric.yarns[0].yarnTwist_per_m = 500;
  fabric.yarns[0].layout = FibreLayout::random;
  return fabric;
}

class Density : public testing::TestWithParam<int> {
 protected:
  DensityStudy study(const Fabric& fabric) { return *studyDensity(fabric, GetParam(), Task{}); }
};

TEST_P(Density, OfTheVolumeIsTheLengthInTheVoxel) {
  for (const Fabric& fabric : {test::whiteCotton(), twoPly()}) {
    const DensityError ours = study(fabric).errors.front();
    // A component's density is rounded by 0.025 % at most, once for itself and once for what the voxel before lost.
    EXPECT_LT(ours.voxel_percent, 0.05);
    EXPECT_NEAR(ours.length_percent, 0, 0.05);
    EXPECT_LT(ours.astray_percent, 0.01);
  }
}

TEST_P(Density, BeatsFibreCountingInSpheres) {
  for (const Fabric& fabric : {test::whiteCotton(), twoPly()}) {
    const DensityStudy density = study(fabric);
    ASSERT_EQ(density.errors.size(), 4u);
    const DensityError& ours = density.errors.front();
    // The mean over the voxel is the best that a voxel can say of what is in it; any other number adds its own error:
    // with squares relative to those of the fine density, 1 - ours^2 of which lie in the means.
    for (size_t i = 1; i < density.errors.size(); ++i) {
      const DensityError& counted = density.errors[i];
      EXPECT_GT(counted.voxel_percent, 10) << counted.method;
      EXPECT_GT(counted.fine_percent, ours.fine_percent) << counted.method;
      const double o = ours.fine_percent / 100, c = counted.fine_percent / 100, v = counted.voxel_percent / 100;
      EXPECT_NEAR(c * c, o * o + v * v * (1 - o * o), 1e-3 * v) << counted.method;
    }
    // A sphere that reaches beyond its voxel finds fibres where there are none.
    EXPECT_GT(density.errors.back().astray_percent, 1);
  }
}

TEST_P(Density, LineCrossesTheYarn) {
  const DensityStudy density = study(test::whiteCotton());
  double exact = 0, ours = 0;
  for (const DensityStudy::Place& place : density.line) {
    exact += place.exact;
    ours += place.ours;
  }
  EXPECT_GT(exact, 0);
  EXPECT_NEAR(ours, exact, 1e-3 * exact);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, Density, testing::Values(4, 8));

}  // namespace
}  // namespace loomlight
