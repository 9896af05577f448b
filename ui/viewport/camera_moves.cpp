#include "ui/viewport/camera_moves.h"

#include <algorithm>
#include <cmath>

#include "core/fabric/model/height_seen.h"

namespace loomlight {
namespace {

constexpr double kDegreesPerPixel = 0.35;
constexpr double kZoomPerClick = 0.14;

double radians(double degrees) {
  return degrees * kPi / 180.0;
}

struct Axes {
  glm::dvec3 right, up;
};

Axes axesOf(const Camera& camera) {
  const double a = radians(camera.azimuth_deg), e = radians(camera.elevation_deg);
  const glm::dvec3 forward(-std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a), -std::sin(e));
  const glm::dvec3 right(-std::sin(a), std::cos(a), 0.0);
  return {right, glm::cross(right, forward)};
}

/// Millimetres per pixel at the target.
double pixelSize_mm(const Camera& camera, int height) {
  return heightSeen_mm(camera) / std::max(height, 1);
}

/// Half extents of the drape, for a sphere around it.
double radiusOf(const Drape& drape, const MeshExtent& mesh) {
  switch (drape.kind) {
    case DrapeKind::flat:
      return 0.5 * std::hypot(drape.width_mm, drape.height_mm);
    case DrapeKind::cylinder: {
      const double across = std::min(drape.width_mm / 2, drape.radius_mm);
      return std::hypot(across, drape.height_mm / 2);
    }
    case DrapeKind::sphere:
      return std::min(drape.radius_mm, 0.5 * std::hypot(drape.width_mm, drape.height_mm));
    default:
      return mesh.radius_mm;
  }
}

}  // namespace

bool hasOwnExtent(const Drape& drape) {
  return drape.kind != DrapeKind::flat && drape.kind != DrapeKind::cylinder && drape.kind != DrapeKind::sphere;
}

Camera orbited(const Camera& camera, double dx, double dy) {
  Camera moved = camera;
  moved.azimuth_deg = std::remainder(camera.azimuth_deg - kDegreesPerPixel * dx, 360.0);
  moved.elevation_deg = std::clamp(camera.elevation_deg + kDegreesPerPixel * dy, -90.0, 90.0);
  return moved;
}

Camera panned(const Camera& camera, double dx, double dy, int height) {
  const Axes axes = axesOf(camera);
  const double size = pixelSize_mm(camera, height);
  Camera moved = camera;
  moved.target_mm += size * (-dx * axes.right + dy * axes.up);
  return moved;
}

Camera zoomed(const Camera& camera, double clicks, double x, double y, int height) {
  Camera moved = camera;
  moved.distance_mm = std::clamp(camera.distance_mm * std::exp(-kZoomPerClick * clicks), 0.1, 100000.0);
  const Axes axes = axesOf(camera);
  const double shrink = pixelSize_mm(camera, height) - pixelSize_mm(moved, height);
  moved.target_mm += shrink * (x * axes.right - y * axes.up);
  return moved;
}

Camera turnedTo(const Camera& camera, Viewpoint viewpoint) {
  constexpr double kElevations_deg[] = {90, 35, 12};
  Camera turned = camera;
  turned.azimuth_deg = -90;
  turned.elevation_deg = kElevations_deg[static_cast<size_t>(viewpoint)];
  return turned;
}

Camera atScale(const Camera& camera, int height, double pixels_per_mm) {
  Camera moved = camera;
  moved.distance_mm = std::clamp(camera.distance_mm / (pixels_per_mm * pixelSize_mm(camera, height)), 0.1, 100000.0);
  return moved;
}

Camera aboveFlat(const Camera& camera, double width_mm, double height_mm, double aspect) {
  Camera moved = turnedTo(camera, Viewpoint::above);
  moved.target_mm = glm::dvec3(0.0);
  return atScale(moved, 1, 1 / std::max(height_mm, width_mm / aspect));
}

Camera fitted(const Camera& camera, const Drape& drape, double aspect, const MeshExtent& mesh) {
  constexpr double kMargin = 1.02;
  Camera moved = camera;
  moved.target_mm = hasOwnExtent(drape) ? mesh.centre_mm : glm::dvec3(0.0);
  const double half = std::atan(0.5 * heightSeenPerDistance(camera) * std::min(1.0, aspect));
  moved.distance_mm = std::clamp(kMargin * radiusOf(drape, mesh) / std::sin(half), 0.1, 100000.0);
  return moved;
}

}  // namespace loomlight
