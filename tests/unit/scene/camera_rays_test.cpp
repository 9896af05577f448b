#include "render/scene/camera_rays.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loomlight {
namespace {

void expectNear(glm::vec3 a, glm::vec3 b, float tolerance) {
  EXPECT_LE(glm::length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z;
}

/// Where a ray meets the plane through p across n.
glm::vec3 meet(const Ray& ray, glm::vec3 p, glm::vec3 n) {
  return ray.origin + glm::dot(p - ray.origin, n) / glm::dot(ray.direction, n) * ray.direction;
}

Camera view(double azimuth_deg, double elevation_deg, double fov_deg) {
  Camera camera;
  camera.target_mm = {1, 2, 3};
  camera.azimuth_deg = azimuth_deg;
  camera.elevation_deg = elevation_deg;
  camera.distance_mm = 50;
  camera.fov_deg = fov_deg;
  return camera;
}

TEST(CameraRays, TheMiddleOfThePictureLooksAtTheTarget) {
  for (const double fov : {0.0, 20.0, 90.0}) {
    for (const double elevation : {-90.0, -20.0, 0.0, 50.0, 90.0}) {
      for (const double azimuth : {-90.0, 10.0, 200.0}) {
        const CameraRays rays(view(azimuth, elevation, fov), 300, 200);
        const Ray ray = rays.ray(150, 100);
        EXPECT_NEAR(glm::distance(rays.eye_mm(), glm::vec3(1, 2, 3)), 50, 1e-4);
        expectNear(ray.origin, rays.eye_mm(), 1e-4f);
        expectNear(ray.origin + 50.0f * ray.direction, {1, 2, 3}, 1e-4f);
      }
    }
  }
}

TEST(CameraRays, StandsWhereTheAnglesSay) {
  expectNear(CameraRays(view(0, 0, 20), 10, 10).eye_mm(), {51, 2, 3}, 1e-4f);
  expectNear(CameraRays(view(-90, 0, 20), 10, 10).eye_mm(), {1, -48, 3}, 1e-4f);
  expectNear(CameraRays(view(33, 90, 20), 10, 10).eye_mm(), {1, 2, 53}, 1e-4f);
}

TEST(CameraRays, ZIsUpAndFromAboveYIs) {
  const CameraRays front(view(-90, 30, 20), 100, 100);
  EXPECT_GT(front.ray(50, 0).direction.z, front.ray(50, 100).direction.z);
  EXPECT_GT(front.ray(100, 50).direction.x, front.ray(0, 50).direction.x);
  const CameraRays above(view(-90, 90, 20), 100, 100);
  EXPECT_GT(above.ray(50, 0).direction.y, 0.1f);
  EXPECT_GT(above.ray(100, 50).direction.x, 0.1f);
}

TEST(CameraRays, OrbitingOverThePoleDoesNotJump) {
  for (const double azimuth : {-90.0, 0.0, 77.0}) {
    const CameraRays before(view(azimuth, 89.999, 20), 100, 100), at(view(azimuth, 90, 20), 100, 100);
    expectNear(before.ray(10, 20).direction, at.ray(10, 20).direction, 1e-4f);
  }
}

TEST(CameraRays, TheFieldOfViewIsVerticalAndPixelsAreSquare) {
  for (const double fov : {0.0, 20.0, 60.0}) {
    const CameraRays rays(view(-60, 35, fov), 400, 100);
    const glm::vec3 target(1, 2, 3), n = rays.ray(200, 50).direction;
    const glm::vec3 top = meet(rays.ray(200, 0), target, n), bottom = meet(rays.ray(200, 100), target, n);
    const glm::vec3 left = meet(rays.ray(0, 50), target, n), right = meet(rays.ray(400, 50), target, n);
    const double height = 2 * 50 * std::tan((fov == 0 ? 20 : fov) * kPi / 360);
    EXPECT_NEAR(glm::distance(top, bottom), height, 1e-3);
    EXPECT_NEAR(glm::distance(left, right), 4 * height, 4e-3);
    EXPECT_NEAR(rays.pixelSize_mm(50), height / 100, 1e-4);
  }
}

TEST(CameraRays, OrthographicRaysAreParallel) {
  const CameraRays rays(view(20, 40, 0), 64, 64);
  expectNear(rays.ray(0, 0).direction, rays.ray(64, 64).direction, 0);
  EXPECT_EQ(rays.pixelSize_mm(1), rays.pixelSize_mm(1000));
  const CameraRays perspective(view(20, 40, 30), 64, 64);
  EXPECT_NEAR(perspective.pixelSize_mm(10) / perspective.pixelSize_mm(1), 10, 1e-4);
}

TEST(CameraRays, DirectionsAreUnit) {
  const CameraRays rays(view(20, 40, 120), 64, 48);
  for (float x = 0; x <= 64; x += 8) {
    for (float y = 0; y <= 48; y += 8) EXPECT_NEAR(glm::length(rays.ray(x, y).direction), 1, 1e-6);
  }
}

// As in a picture of 7 x 5 pixels, of which 3 x 3 make one: the last of its three columns and two rows are not whole.
TEST(CameraRays, ACoarsePixelStandsForWholeFineOnes) {
  for (const double fov : {0.0, 30.0}) {
    const CameraRays fine(view(20, 40, fov), 7, 5), coarse(view(20, 40, fov), 7, 5, 3);
    for (int y = 0; y <= 2; ++y)
      for (int x = 0; x <= 3; ++x) {
        const auto u = static_cast<float>(x), v = static_cast<float>(y);
        const Ray a = coarse.ray(u, v), b = fine.ray(3 * u, 3 * v);
        expectNear(a.origin, b.origin, 1e-4f);
        expectNear(a.direction, b.direction, 1e-6f);
        EXPECT_NEAR(a.cone.widthAt(50), 3 * b.cone.widthAt(50), 1e-4);
        const auto seen = coarse.project(a.origin + 41.0f * a.direction);
        ASSERT_TRUE(seen);
        EXPECT_NEAR(seen->x, u, 1e-4);
        EXPECT_NEAR(seen->y, v, 1e-4);
      }
    EXPECT_NEAR(coarse.pixelSize_mm(50), 3 * fine.pixelSize_mm(50), 1e-4);
  }
}

TEST(CameraRays, ProjectsAPointToThePixelWhoseRayMeetsIt) {
  for (const double fov : {0.0, 30.0}) {
    const CameraRays rays(view(20, 40, fov), 64, 48);
    for (const glm::vec2 pixel : {glm::vec2(3.5f, 40.25f), glm::vec2(32, 24), glm::vec2(80, -9)}) {
      const Ray ray = rays.ray(pixel.x, pixel.y);
      const auto seen = rays.project(ray.origin + 41.0f * ray.direction);
      ASSERT_TRUE(seen);
      EXPECT_NEAR(seen->x, pixel.x, 1e-2);
      EXPECT_NEAR(seen->y, pixel.y, 1e-2);
      EXPECT_NEAR(seen->distance_mm, 41, 1e-3);
    }
    const Ray middle = rays.ray(32, 24);
    EXPECT_FALSE(rays.project(middle.origin - 1.0f * middle.direction));
  }
}

}  // namespace
}  // namespace loomlight
