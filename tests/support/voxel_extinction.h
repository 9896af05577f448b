#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/volume/pool/tangent_spread.h"
#include "core/volume/traverse/cloth_volume.h"
#include "render/media/known_fibre.h"
#include "render/media/shell_walk.h"

namespace loomlight::test {

// What one ray meets of the fibres of a voxel, in plain numbers: what the lanes (render/walk) are held against.

/// [system][index into Fabric::yarns]
using YarnTables = std::array<std::vector<YarnOptics>, 2>;

/// A component's fibres as they lie in the world.
inline FibreDistribution inWorld(FibreDistribution fibres, const LocalDrape& drape) {
  if (!drape.isometric) {
    float stretch = 1;
    fibres.direction = drape.tangent(fibres.direction, stretch);
    fibres.lengthDensity *= stretch * drape.densityScale;
  }
  return fibres;
}

/// What a ray in direction d (unit) meets of a component: sigma_i(d) = 2 r lambda_i I(angle(d, m_i), s_i), 1/mm (Eqs.
/// 6-9 of the report).
inline float extinction(const FibreDistribution& fibres, const YarnOptics& optics, glm::vec3 direction) {
  const float cosine = glm::dot(direction, fibres.direction);
  const float sineSquared = std::max(0.0f, 1.0f - cosine * cosine);
  return 2.0f * optics.fibreRadius_mm * fibres.lengthDensity *
         TangentSpread::table().projectedLengthOfSquare(sineSquared, fibres.spread);
}

/// A component of a voxel, and whose it is; the content must outlive it.
struct VoxelFibres {
  FibreDistribution fibres;  ///< in the world, spread over the voxel
  VoxelBox box;              ///< where in the voxel they lie
  const YarnOptics* optics = nullptr;
  const VoxelContent::YarnSpan* span = nullptr;

  YarnId yarnId() const { return {span->system, span->index}; }
};

/// Calls visit(const VoxelFibres&) for each component of a voxel.
template <class Visit>
void forEachComponent(const YarnTables& yarns, const VoxelContent& content, const LocalDrape& drape, Visit&& visit) {
  for (int p = 0; p < content.count; ++p) {
    const VoxelContent::YarnSpan& span = content.spans[p];
    const YarnOptics& optics = yarns[static_cast<int>(span.system)][span.yarn];
    for (const Component& component : span.components)
      visit(VoxelFibres{inWorld(component.decode(), drape), component.box(), &optics, &span});
  }
}

/// The share of a component's extinction that counts: all of it. Others are functions of the same argument.
struct WholeExtinction {
  float operator()(const VoxelFibres&) const { return 1; }
};

/// At a place in the voxel, in widths of it, are only components whose boxes it is in: each as much denser there as its
/// box is smaller than the voxel.
struct ExtinctionAt {
  glm::vec3 inVoxel{0};
  float operator()(const VoxelFibres& component) const {
    return component.box.contains(inVoxel) ? component.box.crowding() : 0;
  }
};

/// Whether it takes a choice which component of a voxel with content is met.
inline bool hasSeveralComponents(const VoxelContent& content) {
  return content.count > 1 || content.spans[0].components.size() > 1;
}

/// The component that a collision is with, of a voxel with content, in proportion to what counts of extinction; u in
/// [0, 1). EventLaw::report chooses by density alone (Eq. 12), which is biased where components are seen at different
/// angles.
inline VoxelFibres chooseComponent(const YarnTables& yarns, const VoxelContent& content, const LocalDrape& drape,
                                   glm::vec3 direction, float u, EventLaw law) {
  int chosen = 0;
  if (hasSeveralComponents(content)) {
    std::array<float, 2 * VoxelContent::kMaxSpans> weights;
    int count = 0;
    float sum = 0;
    forEachComponent(yarns, content, drape, [&](const VoxelFibres& component) {
      const float weight = law == EventLaw::report ? component.fibres.lengthDensity
                                                   : extinction(component.fibres, *component.optics, direction);
      weights[count++] = weight;
      sum += weight;
    });
    for (float rest = u * sum; chosen + 1 < count; ++chosen) {
      rest -= weights[chosen];
      if (rest < 0) break;
    }
  }
  VoxelFibres met{};
  int number = 0;
  forEachComponent(yarns, content, drape, [&](const VoxelFibres& component) {
    if (number++ == chosen) met = component;
  });
  return met;
}

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

}  // namespace loomlight::test
