#pragma once

#include <cmath>

#include "core/base/units.h"

namespace loomlight {

/// Orthonormal, right-handed frame of a fibre: x along the tangent, the frame of FibreBcsdf. Duff et al. 2017,
/// "Building an orthonormal basis, revisited": exact to rounding for any tangent, without a root or a branch.
struct FibreFrame {
  glm::vec3 x, y, z;

  explicit FibreFrame(glm::vec3 tangent) : x(tangent) {
    const float sign = std::copysign(1.0f, x.z), a = -1 / (sign + x.z), b = x.x * x.y * a;
    y = {1 + sign * x.x * x.x * a, sign * b, -sign * x.x};
    z = {b, sign + x.y * x.y * a, -x.y};
  }
  glm::vec3 toLocal(glm::vec3 v) const { return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)}; }
  glm::vec3 toWorld(glm::vec3 v) const { return v.x * x + v.y * y + v.z * z; }
};

}  // namespace loomlight
