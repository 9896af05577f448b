#include "app/bench/studies/density_study.h"

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

// All of it is found, but for what the section of a fibre shares with voxels beyond those that are looked at.
TEST_P(Density, OfTheVolumeIsAllThereIs) {
  for (const Fabric& fabric : {test::whiteCotton(), twoPly()}) {
    const DensityError ours = study(fabric).errors.front();
    EXPECT_NEAR(ours.length_percent, 0, 0.5);
    EXPECT_LT(ours.astray_percent, 0.5);
  }
}

// By whichever size of sphere: within the voxel it leaves corners out, beyond the voxel it finds fibres where there are
// none, a hundred times as many as the volume does. The volume spreads a fibre over its section by two lines that waver
// across it, and is off by that.
TEST_P(Density, BeatsFibreCountingInSpheres) {
  for (const Fabric& fabric : {test::whiteCotton(), twoPly()}) {
    const DensityStudy density = study(fabric);
    ASSERT_EQ(density.errors.size(), 4u);
    const DensityError& ours = density.errors.front();
    for (size_t i = 1; i < density.errors.size(); ++i) {
      const DensityError& counted = density.errors[i];
      EXPECT_LT(ours.voxel_percent, counted.voxel_percent) << counted.method;
      EXPECT_LT(ours.fine_percent, counted.fine_percent) << counted.method;
    }
    EXPECT_GT(density.errors.back().astray_percent, 100 * ours.astray_percent);
  }
}

TEST_P(Density, LineCrossesTheYarn) {
  const DensityStudy density = study(test::whiteCotton());
  double exact = 0, ours = 0;
  for (const DensityStudy::Sample& sample : density.line) {
    exact += sample.exact;
    ours += sample.ours;
  }
  EXPECT_GT(exact, 0);
  // A dozen voxels of four samples each, each voxel off by what two lines miss of a section: three sigma of their sum.
  const double voxels = static_cast<double>(density.line.size()) / 4;
  const double sigma = 0.01 * density.errors.front().voxel_percent / std::sqrt(voxels);
  EXPECT_LT(sigma, 0.04);
  EXPECT_NEAR(ours, exact, 3 * sigma * exact);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, Density, testing::Values(4, 8));

}  // namespace
}  // namespace loomlight
