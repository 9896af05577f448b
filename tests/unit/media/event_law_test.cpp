#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "render/media/voxel_extinction.h"
#include "tests/support/voxel_walk.h"

namespace loomlight {
namespace {

/// A voxel of straight warp (along y) and weft (along x) of equal density.
struct CrossedVoxel {
  Component warp = Component::encode({{0, 1, 0}, 0.0f, 1000.0f});
  Component weft = Component::encode({{1, 0, 0}, 0.0f, 1000.0f});
  YarnTables yarns{{{{0, false, 0.006f}}, {{0, false, 0.006f}}}};

  static VoxelContent of(std::initializer_list<VoxelContent::YarnSpan> spans) {
    VoxelContent content;
    for (const VoxelContent::YarnSpan& span : spans) content.spans[content.count++] = span;
    return content;
  }
  VoxelContent::YarnSpan warpSpan() const { return {{&warp, 1}, System::warp, 0, 0}; }
  VoxelContent::YarnSpan weftSpan() const { return {{&weft, 1}, System::weft, 0, 0}; }

  double shareOfWarp(double elevation_rad, EventLaw law) const {
    // The ray runs over the warp: along y, at an elevation.
    const glm::vec3 d(0, std::cos(elevation_rad), -std::sin(elevation_rad));
    const VoxelContent both = of({warpSpan(), weftSpan()});
    constexpr int kDraws = 20000;
    int hits = 0;
    for (int i = 0; i < kDraws; ++i)
      hits += chooseComponent(yarns, both, {}, d, (i + 0.5f) / kDraws, law).span->system == System::warp;
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

TEST(EventLaw, ChoosesOnlyAmongWhatCounts) {
  const CrossedVoxel voxel;
  const auto weftAlone = [](const VoxelFibres& component) {
    return component.span->system == System::weft ? 0.25f : 0.0f;
  };
  const VoxelContent both = CrossedVoxel::of({voxel.warpSpan(), voxel.weftSpan()});
  const glm::vec3 down(0, 0, -1);
  for (const float u : {0.0f, 0.5f, 0.999f}) {
    const VoxelFibres met = chooseComponent(voxel.yarns, both, {}, down, u, EventLaw::projected, weftAlone);
    EXPECT_EQ(met.span->system, System::weft);
    EXPECT_EQ(met.fibres.direction, voxel.weft.decode().direction);
  }
  const float whole = test::sumExtinction(voxel.yarns, both, {}, down);
  EXPECT_NEAR(test::sumExtinction(voxel.yarns, both, {}, down, weftAlone), 0.125f * whole, 1e-5f * whole);
}

TEST(VoxelExtinction, IsProjectedFibreArea) {
  const CrossedVoxel voxel;
  const glm::vec3 d = glm::normalize(glm::vec3(0.3f, 0.5f, -0.8f));
  const double expected = 2 * 0.006 * 1000 * std::sqrt(1 - d.y * d.y);
  EXPECT_NEAR(test::sumExtinction(voxel.yarns, CrossedVoxel::of({voxel.warpSpan()}), {}, d), expected, 0.01 * expected);
}

TEST(VoxelExtinction, StretchedClothKeepsItsFibres) {
  // Stretched by two along the warp, the same fibres fill twice the room with twice the length: the same density of
  // length, so a ray across meets as many a millimetre as before.
  const CrossedVoxel voxel;
  LocalDrape stretched;
  stretched.frame[1] = {0, 2, 0};
  stretched.densityScale = 0.5f;
  stretched.isometric = false;
  const auto change = [&](const VoxelContent::YarnSpan& span) {
    const VoxelContent content = CrossedVoxel::of({span});
    const glm::vec3 down(0, 0, -1);
    return test::sumExtinction(voxel.yarns, content, stretched, down) /
           test::sumExtinction(voxel.yarns, content, {}, down);
  };
  EXPECT_NEAR(change(voxel.warpSpan()), 1.0, 1e-4);
  // The weft keeps its length and is spread over twice the room.
  EXPECT_NEAR(change(voxel.weftSpan()), 0.5, 1e-4);
}

}  // namespace
}  // namespace loomlight
