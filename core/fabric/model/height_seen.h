#pragma once

#include <cmath>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Field of view from top to bottom, degrees. Without perspective a camera sees as much as with this one.
inline double fieldOfView_deg(const Camera& camera) {
  constexpr double kOrthographic_deg = 20;
  return camera.fov_deg > 0 ? camera.fov_deg : kOrthographic_deg;
}

/// How much a camera sees of the plane through what it looks at, from the top of its picture to the bottom, for each
/// millimetre of its distance.
inline double heightSeenPerDistance(const Camera& camera) {
  return 2 * std::tan(0.5 * fieldOfView_deg(camera) * kPi / 180);
}

/// The same at its distance, mm.
inline double heightSeen_mm(const Camera& camera) {
  return camera.distance_mm * heightSeenPerDistance(camera);
}

}  // namespace loomlight
