#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/base/rgb.h"
#include "core/base/units.h"
#include "render/optics/polynomials.h"

/// The sphere of directions as a rectangle. (u, v) in [0, 1]: v runs from the zenith (+z) down, in proportion to the
/// angle; u is 1/2 towards +x and grows to the right as seen from inside, that is with falling azimuth, so that
/// panoramas are not mirrored.
namespace loomlight {

inline glm::vec3 latLongDirection(float u, float cosTheta) {
  const optics::SinCos<float> azimuth = optics::sinCosPi(1 - 2 * u);
  const float r = std::sqrt(std::max(0.0f, (1 - cosTheta) * (1 + cosTheta)));
  return {r * azimuth.cosine, r * azimuth.sine, cosTheta};
}

inline float latLongU(glm::vec3 d) {
  return 0.5f - std::copysign(optics::angle(d.y, d.x), d.y) * static_cast<float>(0.5 / kPi);
}
inline float latLongV(glm::vec3 d) {
  return optics::angle(std::sqrt(d.x * d.x + d.y * d.y), d.z) * static_cast<float>(1 / kPi);
}

/// The cell, of n along the side, that t in [0, 1] lies in.
inline int cellOf(float t, int n) {
  return std::clamp(static_cast<int>(t * static_cast<float>(n)), 0, n - 1);
}

/// Unit vector from +x towards +y by the azimuth, and up from there by the elevation.
inline glm::dvec3 directionOf(double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * (kPi / 180), e = elevation_deg * (kPi / 180);
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

}  // namespace loomlight
