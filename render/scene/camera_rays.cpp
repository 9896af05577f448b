#include "render/scene/camera_rays.h"

#include <cassert>
#include <cmath>

#include "core/fabric/model/height_seen.h"

namespace loomlight {
namespace {

constexpr double radians(double degrees) {
  return degrees * kPi / 180.0;
}

}  // namespace

CameraRays::CameraRays(const Camera& camera, int width, int height, int divider)
    : middle_(0.5f * glm::vec2(width, height) / static_cast<float>(divider)), orthographic_(camera.fov_deg <= 0.0) {
  assert(width > 0 && height > 0 && divider > 0);
  const double azimuth = radians(camera.azimuth_deg), elevation = radians(camera.elevation_deg);
  const glm::dvec3 outward(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                           std::sin(elevation));
  // From the azimuth rather than from forward x z, so that orbiting over the pole neither jumps nor divides by zero.
  const glm::dvec3 right(-std::sin(azimuth), std::cos(azimuth), 0.0);
  eye_ = camera.target_mm + camera.distance_mm * outward;
  forward_ = -outward;
  right_ = right;
  up_ = glm::cross(outward, right);
  const double slope = 0.5 * heightSeenPerDistance(camera);
  const auto halfHeight = static_cast<float>(orthographic_ ? camera.distance_mm * slope : slope);
  pixelSize_ = 2.0f * halfHeight / static_cast<float>(height) * static_cast<float>(divider);
}

Ray CameraRays::ray(float x, float y) const {
  const glm::vec3 offset = pixelSize_ * ((x - middle_.x) * right_ + (middle_.y - y) * up_);
  if (orthographic_) return {eye_ + offset, forward_, {pixelSize_, 0}};
  return {eye_, glm::normalize(forward_ + offset), {0, pixelSize_}};
}

std::optional<CameraRays::Projection> CameraRays::project(const glm::vec3& point) const {
  const glm::vec3 to = point - eye_;
  const float along = glm::dot(to, forward_);
  if (along <= 0) return std::nullopt;
  const float pixel = pixelSize_mm(along);
  return Projection{middle_.x + glm::dot(to, right_) / pixel, middle_.y - glm::dot(to, up_) / pixel,
                    orthographic_ ? along : glm::length(to)};
}

float CameraRays::pixelSize_mm(float distance) const {
  return orthographic_ ? pixelSize_ : pixelSize_ * distance;
}

}  // namespace loomlight
