#include "app/cli/view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/scene/camera_rays.h"

namespace loomlight {
namespace {

/// Where a point comes to lie in the picture, from -1 to 1 both ways; found from the rays of the picture's edges.
glm::dvec2 inPicture(const Camera& camera, int width, int height, glm::dvec3 point) {
  const CameraRays rays(camera, width, height);
  const Ray middle = rays.ray(0.5f * width, 0.5f * height), right = rays.ray(width, 0.5f * height),
            top = rays.ray(0.5f * width, 0);
  const glm::dvec3 forward(middle.direction), offset = point - glm::dvec3(middle.origin);
  const double depth = glm::dot(offset, forward);
  const auto edge = [&](const Ray& ray) {  // of the picture, at that depth
    const glm::dvec3 direction(ray.direction);
    return direction / glm::dot(direction, forward) * depth - forward * depth;
  };
  const glm::dvec3 x = edge(right), y = edge(top);
  return {glm::dot(offset, x) / glm::dot(x, x), glm::dot(offset, y) / glm::dot(y, y)};
}

class ViewOfDrape : public testing::TestWithParam<DrapeKind> {};

TEST_P(ViewOfDrape, ShowsAllOfThePieceAndLittleElse) {
  Fabric fabric;
  fabric.drape.kind = GetParam();
  const DrapeMesh mesh = makeDrape(fabric.drape);
  for (const char* name : {"front", "top", "side"})
    for (const int width : {240, 640}) {
      fabric.render.width = width;
      fabric.render.height = 400;
      const Camera camera = cameraOf(*viewPreset(name), fabric, mesh);
      double furthest = 0;
      for (const glm::vec3& position : mesh.positions) {
        const glm::dvec2 at = inPicture(camera, width, 400, glm::dvec3(position));
        furthest = std::max({furthest, std::abs(at.x), std::abs(at.y)});
      }
      EXPECT_LT(furthest, 1.0) << name;
      EXPECT_GT(furthest, 0.9) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(All, ViewOfDrape, testing::Values(DrapeKind::flat, DrapeKind::cylinder, DrapeKind::sphere));

TEST(View, CloseUpsLookAtTheSurface) {
  Fabric fabric;
  fabric.drape.kind = DrapeKind::sphere;
  const DrapeMesh mesh = makeDrape(fabric.drape);
  const Camera camera = cameraOf(*viewPreset("macro"), fabric, mesh);
  double highest = -1e9;
  for (const glm::vec3& position : mesh.positions) highest = std::max(highest, static_cast<double>(position.z));
  EXPECT_NEAR(camera.target_mm.z, highest, 0.05);
  const double seen_mm = 2 * camera.distance_mm * std::tan(camera.fov_deg * kPi / 360);
  EXPECT_NEAR(seen_mm, 4 * fabric.warpPitch_mm(), 1e-9);
}

TEST(View, NamesAreKnown) {
  for (const char* name : {"front", "top", "side", "close", "macro"}) EXPECT_TRUE(viewPreset(name).has_value());
  EXPECT_FALSE(viewPreset("behind").has_value());
}

}  // namespace
}  // namespace loomlight
