#pragma once

#include "core/base/simd.h"
#include "core/base/units.h"

namespace loomlight {

/// Orthonormal, right-handed frame of a fibre: x along the tangent, the frame of FibreBcsdf. Duff et al. 2017,
/// "Building an orthonormal basis, revisited": exact to rounding for any tangent, without a root or a branch.
/// Vector: glm::vec3 of one fibre, or Vec3Of of several side by side.
template <class Vector>
struct FibreFrameOf {
  Vector x, y, z;

  explicit FibreFrameOf(const Vector& tangent) : x(tangent) {
    const auto sign = signOf(x.z), a = -1 / (sign + x.z), b = x.x * x.y * a;
    y = {1 + sign * x.x * x.x * a, sign * b, -sign * x.x};
    z = {b, sign + x.y * x.y * a, -x.y};
  }
  Vector toLocal(const Vector& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
  Vector toWorld(const Vector& v) const { return v.x * x + v.y * y + v.z * z; }
};
using FibreFrame = FibreFrameOf<glm::vec3>;

}  // namespace loomlight
