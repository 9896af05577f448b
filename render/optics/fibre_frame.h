#pragma once

#include <cmath>

#include "core/base/units.h"

namespace loomlight {

/// Orthonormal, right-handed frame of a fibre: x along the tangent, the frame of FibreBcsdf.
struct FibreFrame {
  glm::vec3 x, y, z;

  explicit FibreFrame(glm::vec3 tangent) : x(tangent) {
    const glm::vec3 helper = std::abs(x.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
    y = glm::normalize(glm::cross(helper, x));
    z = glm::cross(x, y);
  }
  glm::vec3 toLocal(glm::vec3 v) const { return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)}; }
  glm::vec3 toWorld(glm::vec3 v) const { return v.x * x + v.y * y + v.z * z; }
};

}  // namespace loomlight
