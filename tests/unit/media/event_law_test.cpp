#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "render/media/voxel_extinction.h"

namespace loomlight {
namespace {

/// A voxel of straight warp (along y) and weft (along x) of equal density.
struct CrossedVoxel {
  Component warp = Component::encode({{0, 1, 0}, 0.0f, 1000.0f});
  Component weft = Component::encode({{1, 0, 0}, 0.0f, 1000.0f});
  YarnOptics optics{0, false, 0.006f};

  double shareOfWarp(double elevation_rad, EventLaw law) const {
    // The ray runs over the warp: along y, at an elevation.
    const glm::vec3 d(0, std::cos(elevation_rad), -std::sin(elevation_rad));
    VoxelExtinction voxel(d);
    voxel.add(warp, LocalDrape{}, optics, {}, 0);
    voxel.add(weft, LocalDrape{}, optics, {}, 1);
    constexpr int kDraws = 20000;
    int hits = 0;
    for (int i = 0; i < kDraws; ++i) hits += voxel.choose((i + 0.5f) / kDraws, law).yarn == 0;
    return static_cast<double>(hits) / kDraws;
  }
};

TEST(EventLaw, ChoosesYarnsAsARayMeetsThem) {
  // A fibre shows sin(angle) of its length to a ray: of the warp, seen end-on, sin e; of the weft, seen from the side,
  // all. With a black warp and a white weft this share is the colour at grazing angles.
  const CrossedVoxel voxel;
  for (const double degrees : {5.0, 10.0, 20.0, 45.0, 90.0}) {
    const double e = degrees * kPi / 180;
    EXPECT_NEAR(voxel.shareOfWarp(e, EventLaw::projected), std::sin(e) / (1 + std::sin(e)), 0.005) << degrees;
  }
}

TEST(EventLaw, OfTheReportIgnoresTheAngle) {
  const CrossedVoxel voxel;
  for (const double degrees : {5.0, 20.0, 90.0})
    EXPECT_NEAR(voxel.shareOfWarp(degrees * kPi / 180, EventLaw::report), 0.5, 0.005);
}

TEST(VoxelExtinction, IsProjectedFibreArea) {
  const CrossedVoxel voxel;
  const glm::vec3 d = glm::normalize(glm::vec3(0.3f, 0.5f, -0.8f));
  VoxelExtinction extinction(d);
  extinction.add(voxel.warp, LocalDrape{}, voxel.optics, {}, 0);
  const double expected = 2 * 0.006 * 1000 * std::sqrt(1 - d.y * d.y);
  EXPECT_NEAR(extinction.total(), expected, 0.01 * expected);
}

TEST(VoxelExtinction, StretchedClothKeepsItsFibres) {
  // Stretched by two along the warp, the same fibres fill twice the room with twice the length: the same density of
  // length, so a ray across meets as many a millimetre as before.
  const CrossedVoxel voxel;
  LocalDrape stretched;
  stretched.frame[1] = {0, 2, 0};
  stretched.densityScale = 0.5f;
  stretched.isometric = false;
  VoxelExtinction before({0, 0, -1}), after({0, 0, -1});
  before.add(voxel.warp, LocalDrape{}, voxel.optics, {}, 0);
  after.add(voxel.warp, stretched, voxel.optics, {}, 0);
  EXPECT_NEAR(after.total() / before.total(), 1.0, 1e-4);
  // The weft keeps its length and is spread over twice the room.
  VoxelExtinction weftBefore({0, 0, -1}), weftAfter({0, 0, -1});
  weftBefore.add(voxel.weft, LocalDrape{}, voxel.optics, {}, 1);
  weftAfter.add(voxel.weft, stretched, voxel.optics, {}, 1);
  EXPECT_NEAR(weftAfter.total() / weftBefore.total(), 0.5, 1e-4);
}

}  // namespace
}  // namespace loomlight
