#pragma once

#include "core/base/simd.h"
#include "render/optics/fibre_frame.h"
#include "render/optics/polynomials.h"

namespace loomlight {

// How a ray lies across the fibre that it meets; T: of one ray, or of several side by side.

/// The offset h at which a fibre is met whose axis was looked for by a point w of the unit hemisphere about the ray.
template <class T>
class OffsetAcross {
 public:
  /// Both unit.
  OffsetAcross(const Vec3Of<T>& incoming, const Vec3Of<T>& tangent) {
    const FibreFrameOf<Vec3Of<T>> frame(incoming);
    const Vec3Of<T> b = cross(tangent, incoming);
    // The shift leads from the surface to the axis, so the normal's component across is its negative.
    const T scale = -1 / squareRoot(dot(b, b));
    x_ = scale * dot(frame.y, b);
    y_ = scale * dot(frame.z, b);
  }
  T operator()(const Vec3Of<T>& w) const { return optics::withinOne<T>(w.x * x_ + w.y * y_); }

 private:
  T x_, y_;
};

/// Unit normal of the fibre's surface where a ray meets it at offset h.
template <class T>
Vec3Of<T> surfaceNormal(const Vec3Of<T>& incoming, const Vec3Of<T>& tangent, T h) {
  const Vec3Of<T> b = cross(tangent, incoming), forward = incoming - dot(incoming, tangent) * tangent;
  return (1 / squareRoot(dot(b, b))) * (h * b - squareRoot(1 - h * h) * forward);
}

}  // namespace loomlight
