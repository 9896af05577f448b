#include <gtest/gtest.h>

#include "core/geometry/yarn/yarn_model.h"

namespace loomlight {
namespace {

/// A ring-spun yarn of 300 fibres.
double separation(double disorder_deg, double migration = 0, FibreLayout layout = FibreLayout::packed) {
  Yarn yarn;
  yarn.fibresPerPly = 300;
  yarn.packing = 0.55;
  yarn.plyTwist_per_m = 500;
  yarn.migration = migration;
  yarn.fibreDisorder_deg = disorder_deg;
  yarn.layout = layout;
  const Fibre fibre;
  YarnGeometry geometry = outlineYarn(yarn, fibre, 0.4, 0.4, 0.5, 0);
  resolveTwist(geometry, yarn, 0.42);
  return makeYarnModel(sourceOf(geometry, yarn, fibre))->separation;
}

TEST(Separation, OfPackedFibresThatKeepTheirPlacesIsOne) {
  EXPECT_EQ(separation(0), 1);
}

// Parted all along their ways, they still touch where the yarn is pressed.
TEST(Separation, OfPackedFibresThatMigrateIsNearOne) {
  EXPECT_GT(separation(0, 0.3), 0.7);
  EXPECT_LT(separation(0, 0.3), 1);
}

// They are not parted once more where they stray (Migration), so the farther they do the more they lie at random.
TEST(Separation, FallsAsFibresStray) {
  double before = separation(0);
  ASSERT_GT(before, 0);
  for (const double degrees : {2.0, 4.0, 8.0}) {
    const double now = separation(degrees);
    EXPECT_LT(now, before - 0.05) << degrees;
    before = now;
  }
  EXPECT_LT(before, 0.25);
}

TEST(Separation, OfFibresAtRandomIsNearNought) {
  EXPECT_LT(separation(0, 0, FibreLayout::random), 0.1);
  EXPECT_LT(separation(0, 0.3, FibreLayout::random), 0.1);
}

}  // namespace
}  // namespace loomlight
