#include "render/scene/curve_run.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/simd.h"

// How it works. A ray is met with the endless cylinders about all segments at once. Where it comes into one of them
// between the ends of the segment, it comes into the segment; where before or beyond these, it can only come in through
// the ball about that end, which the cylinder holds. Of two segments that meet at an angle the ball of the joint shows
// in the wedge that lies beyond both. The rest of it is inside of one or the other, where a ray that is inside of the
// fibre already (it has come in through another cell) must not meet it. A joint's ball is the later segment's.

namespace loomlight {
namespace {

using Lanes = Float32x4;
static_assert(kLanes<Lanes> == CurveRun::kSegments);

/// How far before the wedge of a joint its ball still counts, in radii: rounding must not leave a crack between two
/// segments in line. It lies 5e-7 of the radius deep there.
constexpr float kJointSlack = 1e-3f;

Lanes loaded(const float* numbers) {
  Lanes lanes;
  std::memcpy(&lanes, numbers, sizeof(lanes));
  return lanes;
}

Vec3Of<Lanes> inAll(glm::vec3 v) {
  return {broadcast<Lanes>(v.x), broadcast<Lanes>(v.y), broadcast<Lanes>(v.z)};
}

}  // namespace

CurveRun::CurveRun(std::span<const glm::vec3> points, float radius_mm) : radius_mm_(radius_mm) {
  for (size_t i = 0; i < x_.size(); ++i) {
    const glm::vec3 point = points[std::min(i, points.size() - 1)];
    x_[i] = point.x;
    y_[i] = point.y;
    z_[i] = point.z;
  }
}

CurveRun::Hits CurveRun::meet(glm::vec3 origin, glm::vec3 direction, const CurvePart& part,
                              const CurveRun* previous) const {
  const Vec3Of<Lanes> start{loaded(&x_[0]), loaded(&y_[0]), loaded(&z_[0])};
  const Vec3Of<Lanes> axis = Vec3Of<Lanes>{loaded(&x_[1]), loaded(&y_[1]), loaded(&z_[1])} - start;
  const Vec3Of<Lanes> from = inAll(origin) - start, along = inAll(direction);
  const Lanes axis2 = dot(axis, axis), directionOn = dot(axis, along), fromOn = dot(axis, from);
  // a t^2 + 2 b t + c = 0, of which h is a fourth of the discriminant. By the distance of the two lines, not as a
  // difference of squares, in which what rounding leaves grows with the square of a segment's length in radii.
  const Vec3Of<Lanes> across = cross(axis, along);
  const Lanes a = dot(across, across), b = dot(across, cross(axis, from)), apart = dot(across, from);
  const Lanes h = axis2 * (broadcast<Lanes>(radius_mm_ * radius_mm_) * a - apart * apart);
  Hits hits;
  const auto passes = (h >= 0) & (axis2 > 0);  // there are segments, and the ray does not pass by
  if (!any(passes)) return hits;

  const Lanes t = (-b - squareRoot(most(h, Lanes{}))) / a, on = fromOn + t * directionOn;
  for (int i = 0; i < kSegments; ++i) {
    if (!passes[i]) continue;
    const auto at = static_cast<size_t>(i);
    const bool crosses = a[i] > 0;  // not in parallel
    bool met = crosses && on[i] > 0 && on[i] < axis2[i];
    if (met) {
      hits.t[at] = t[i];
      hits.normal[at] = origin + t[i] * direction - point(i) - on[i] / axis2[i] * (point(i + 1) - point(i));
    } else if (crosses ? on[i] <= 0 : directionOn[i] > 0) {
      met = meetBall(i, origin, direction, hits.t[at], hits.normal[at]);
      if (met && (i > 0 || !part.begins)) {
        const glm::vec3 earlier = point(i) - (i > 0 ? point(i - 1) : previous->point(kSegments - 1));
        met = glm::dot(hits.normal[at], earlier) >= -kJointSlack * radius_mm_ * glm::length(earlier);
      }
    } else if (part.ends && point(i + 1) == point(kSegments)) {
      met = meetBall(i + 1, origin, direction, hits.t[at], hits.normal[at]);
    }
    if (met) hits.segments |= 1u << i;
  }
  return hits;
}

bool CurveRun::meetBall(int end, glm::vec3 origin, glm::vec3 direction, float& t, glm::vec3& normal) const {
  const glm::vec3 from = origin - point(end);
  const float a = glm::dot(direction, direction), b = glm::dot(direction, from);
  const glm::vec3 nearest = from - b / a * direction;
  const float h = radius_mm_ * radius_mm_ - glm::dot(nearest, nearest);
  if (!(h >= 0)) return false;
  t = -b / a - std::sqrt(h / a);
  normal = from + t * direction;
  return true;
}

}  // namespace loomlight
