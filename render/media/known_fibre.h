#pragma once

#include <algorithm>
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
};

/// A flight that ended at a collision: a way now known to be free of fibres.
struct RaySegment {
  glm::vec3 end{0};
  glm::vec3 direction{0, 0, -1};
  float length_mm = 0;  ///< 0: none
};

/// The share of fibres through a point, with tangent m, that would also have blocked a flight: those are not there.
inline float knownAbsent(const RaySegment& segment, glm::vec3 point, glm::vec3 m, float spread, float radius_mm) {
  // Seen along m, fibres are discs, and the flight a line.
  const glm::vec3 offset = point - segment.end;
  const float alongTangent = glm::dot(segment.direction, m);
  const float lineSquare = 1 - alongTangent * alongTangent;
  if (lineSquare < 1e-6f) return 0;
  const float back = -(glm::dot(offset, segment.direction) - alongTangent * glm::dot(offset, m));
  if (back <= 0 || back >= segment.length_mm * lineSquare) return 0;
  const glm::vec3 normal = glm::cross(m, segment.direction);
  // Tangents that spread see the two ways apart by a little more; not where one way is the other, reversed.
  const glm::vec3 separation = offset - glm::dot(offset, segment.direction) * segment.direction;
  const float apart = std::abs(glm::dot(offset, normal)) / std::sqrt(lineSquare) + spread * glm::length(separation);
  return std::max(0.0f, 1 - apart / (2 * radius_mm));
}

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

/// A met fibre as the voxels of the volume hold it: its length, spread over its section.
class FibreInVoxels {
 public:
  /// All in cloth space; the tangent of unit length.
  FibreInVoxels(glm::vec3 axis, glm::vec3 tangent, float radius_mm, const VoxelGrid& grid)
      : axis_(axis), tangent_(tangent), inverse_(1.0f / tangent), voxel_mm_(grid.size_mm), radius_mm_(radius_mm) {}

  /// Length per volume in the voxel with that lower corner, 1/mm^2.
  float lengthDensity(glm::vec3 lower) const {
    const glm::vec3 to = lower + 0.5f * voxel_mm_ - axis_;
    const float along = glm::dot(to, tangent_), reach = 0.5f * glm::length(voxel_mm_) + radius_mm_;
    if (glm::dot(to, to) - along * along > reach * reach) return 0;
    // Lines through the corners of a tetrahedron, which has the second moment of the section, r^2 / 4, any way it lies.
    const float r = 0.5f * radius_mm_;
    float length = 0;
    for (const glm::vec3 corner :
         {glm::vec3(r, r, r), glm::vec3(r, -r, -r), glm::vec3(-r, r, -r), glm::vec3(-r, -r, r)}) {
      // As Kay and Kajiya 1986; a NaN (in the plane of a face) loses every comparison.
      const glm::vec3 a = (lower - axis_ - corner) * inverse_, b = a + voxel_mm_ * inverse_;
      const glm::vec3 enter = glm::min(a, b), leave = glm::max(a, b);
      length += std::max(0.0f, std::min({leave.x, leave.y, leave.z}) - std::max({enter.x, enter.y, enter.z}));
    }
    return 0.25f * length / (voxel_mm_.x * voxel_mm_.y * voxel_mm_.z);
  }

 private:
  glm::vec3 axis_, tangent_, inverse_, voxel_mm_;
  float radius_mm_;
};

}  // namespace loomlight
