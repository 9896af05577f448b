#include "app/export/handover/measured_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/export/handover/surface_samples.h"
#include "tests/unit/handover/two_sided_cloth.h"

namespace loomlight {
namespace {

TEST(MeasuredSurface, WhatAWhiteClothDoesNotLetThroughItScatters) {
  Fabric fabric = test::twoSidedCloth();
  fabric.fibres[0].absorption_per_mm = Rgb(0);
  fabric.render.estimator = Estimator::none;  // the one under which paths are as likely either way
  fabric.render.samplesPerPixel = 8;
  const auto measured = measuredSurface(fabric, 96, 1e9, {});
  ASSERT_TRUE(measured);
  const auto sides = tileSides(fabric, tileExtent(fabric, false), 64, 1e9, {});
  double opacity = 0;
  for (const float value : sides->front.tile.opacity) opacity += value;
  opacity /= static_cast<double>(sides->front.tile.opacity.size());
  // Of light along the normal of the front: what comes back to it, and what comes out of the back.
  const double back = albedoAlongNormal(measured->front.reflected).x;
  const double through = albedoAlongNormal(measured->back.transmitted).x;
  EXPECT_NEAR(back + through, opacity, 0.03);
  EXPECT_GT(through, 0.05);
  // Paths can be walked either way: the maps, lit by half the sky and seen along the normal, have the same mean.
  EXPECT_NEAR(back, meanColours(sides->front).reflected.x, 0.02);
  EXPECT_NEAR(through, meanColours(sides->front).transmitted.x, 0.02);
}

/// RMS of the noise in albedoAlongNormal(), as a share of it.
double relativeNoise(const std::vector<Observation>& seen) {
  double sum = 0;
  for (const Observation& one : seen)
    if (std::abs(one.in.z) > 0.9999f) sum += one.weight * one.weight * one.variance;
  const Rgb albedo = albedoAlongNormal(seen);
  return 3 * std::sqrt(sum) / (albedo.r + albedo.g + albedo.b);
}

/// A satin whose face is of dark warp: of light along the face's normal half as much again is let through as of light
/// along the other one, which leaves the dark fibres at a slant. Each map shows one of the two.
TEST(MeasuredSurface, AMapOfTransmittedLightBelongsToWhatTheOtherSideSends) {
  Fabric fabric = test::twoSidedCloth();
  fabric.weave = satin(8, 3);
  fabric.ends_per_cm = 16;
  for (Fibre& fibre : fabric.fibres) {
    fibre.longitudinalRoughness = 0.6;
    fibre.azimuthalRoughness = 0.9;
  }
  fabric.fibres[0].absorption_per_mm = Rgb(150);
  fabric.render.samplesPerPixel = 16;
  fabric.render.estimator = Estimator::none;  // as above
  auto measured = measuredSurface(fabric, 96, 1e9, {});
  ASSERT_TRUE(measured);
  const auto sides = tileSides(fabric, tileExtent(fabric, false), 64, 1e9, {});
  const MeanColours front = meanColours(sides->front), back = meanColours(sides->back);
  // Ratios, as the piece that is measured need not be quite as bright as the tile.
  const double maps = front.transmitted.x / back.transmitted.x;
  const double seen =
      albedoAlongNormal(measured->back.transmitted).x / albedoAlongNormal(measured->front.transmitted).x;
  const double fourSigmas =
      4 * maps * std::hypot(relativeNoise(measured->front.transmitted), relativeNoise(measured->back.transmitted));
  ASSERT_GT(maps - 1 / maps, 2 * fourSigmas) << "the sides are unlike enough to tell which belongs to which";
  EXPECT_NEAR(seen, maps, fourSigmas);

  scaleToMaps(front, back, *measured);
  EXPECT_NEAR(albedoAlongNormal(measured->back.transmitted).x, front.transmitted.x, 1e-5);
  EXPECT_NEAR(albedoAlongNormal(measured->front.transmitted).x, back.transmitted.x, 1e-5);
  EXPECT_NEAR(albedoAlongNormal(measured->front.reflected).x, front.reflected.x, 1e-5);
  EXPECT_NEAR(albedoAlongNormal(measured->back.reflected).x, back.reflected.x, 1e-5);
}

TEST(MeasuredSurface, TheBackIsSeenFromBelow) {
  const auto measured = measuredSurface(test::twoSidedCloth(), 16, 1e9, {});
  ASSERT_TRUE(measured);
  // Its weft is white, the warp on the face is dark.
  EXPECT_LT(albedoAlongNormal(measured->front.reflected).x, 0.8 * albedoAlongNormal(measured->back.reflected).x);
  for (const MeasuredSide* side : {&measured->front, &measured->back}) {
    for (const Observation& one : side->reflected) EXPECT_GT(one.in.z, 0);
    for (const Observation& one : side->transmitted) EXPECT_LT(one.in.z, 0);
    for (const Observation& one : side->reflected) EXPECT_GT(one.out.z, 0);
  }
}

TEST(MeasuredSurface, IsScaledToAnAlbedo) {
  const glm::vec3 normal(0, 0, 1), slant = glm::normalize(glm::vec3(1, 0, 1));
  std::vector<Observation> seen{
      {normal, normal, Rgb(0.5f), 0.75f}, {normal, slant, Rgb(0.1f, 0.1f, 0), 0.25f}, {slant, normal, Rgb(0.4f), 1}};
  scaleTo(Rgb(0.8f), seen);  // of 0.75 * 0.5 + 0.25 * 0.1 = 0.4, without blue 0.375
  EXPECT_NEAR(seen[0].factor.r, 1, 1e-5);
  EXPECT_NEAR(seen[1].factor.r, 0.2, 1e-5);
  EXPECT_NEAR(seen[2].factor.r, 0.8, 1e-5);
  EXPECT_NEAR(seen[2].factor.b, 0.4 * 0.8 / 0.375, 1e-5);
}

}  // namespace
}  // namespace loomlight
