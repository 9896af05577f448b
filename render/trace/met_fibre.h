#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/trace/medium.h"

namespace loomlight {

// What is known of the fibres near a path, from the flights that it has made.

/// The share of fibres through a point, with tangent m, that would also have blocked a flight: those are not there.
inline float knownAbsent(const Flight& flight, glm::vec3 point, glm::vec3 m, float spread, float radius_mm) {
  // Seen along m, fibres are discs, and the flight a line.
  const glm::vec3 offset = point - flight.end;
  const float alongTangent = glm::dot(flight.direction, m);
  const float lineSquare = 1 - alongTangent * alongTangent;
  if (lineSquare < 1e-6f) return 0;
  const float back = -(glm::dot(offset, flight.direction) - alongTangent * glm::dot(offset, m));
  if (back <= 0 || back >= flight.length_mm * lineSquare) return 0;
  const glm::vec3 normal = glm::cross(m, flight.direction);
  // Tangents that spread see the two ways apart by a little more; not where one way is the other, reversed.
  const glm::vec3 separation = offset - glm::dot(offset, flight.direction) * flight.direction;
  const float apart = std::abs(glm::dot(offset, normal)) / std::sqrt(lineSquare) + spread * glm::length(separation);
  return std::max(0.0f, 1 - apart / (2 * radius_mm));
}

/// Distance at which a ray from outside comes to a straight fibre; infinite if it does not.
inline float distanceTo(const MetFibre& fibre, glm::vec3 origin, glm::vec3 direction) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  if (fibre.radius_mm <= 0) return kNever;
  const glm::vec3 m = fibre.tangent, o = origin - fibre.axis;
  const glm::vec3 across = direction - glm::dot(direction, m) * m, from = o - glm::dot(o, m) * m;
  const float a = glm::dot(across, across), b = glm::dot(across, from);
  const float c = glm::dot(from, from) - fibre.radius_mm * fibre.radius_mm;
  const float discriminant = b * b - a * c;
  if (b >= 0 || c <= 0 || discriminant <= 0) return kNever;
  return (-b - std::sqrt(discriminant)) / a;
}

}  // namespace loomlight
