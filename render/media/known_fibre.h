#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "render/media/medium.h"

namespace loomlight {

// What is known of the fibres near a path, from the flights that it has made.

/// A fibre that light has met: nearby, a straight cylinder.
struct KnownFibre {
  glm::vec3 axis{0};
  glm::vec3 tangent{1, 0, 0};
  float radius_mm = 0;  ///< 0: none
  YarnId yarnId;
  int yarn = 0, end = 0, pick = 0;
  int material = 0;  ///< of a blend, which of its two
};

/// A flight that ended at a collision: a way now known to be free of fibres.
struct RaySegment {
  glm::vec3 end{0};
  glm::vec3 direction{0, 0, -1};
  float length_mm = 0;  ///< 0: none
};

/// What a path knows of the fibres around it.
struct KnownFibres {
  KnownFibre leaving, before;                ///< the last fibre that it met, and the one before
  std::array<RaySegment, 2> pastSegments{};  ///< to both, the newest first
};

/// Distance at which a ray from outside comes to a straight fibre; infinite if it does not.
inline float distanceTo(const KnownFibre& fibre, glm::vec3 origin, glm::vec3 direction) {
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
