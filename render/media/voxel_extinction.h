#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/volume/pool/tangent_spread.h"
#include "core/volume/traverse/cloth_volume.h"
#include "render/media/medium.h"
#include "render/media/shell_walk.h"

namespace loomlight {

// The extinction of each component of a voxel, and the choice of the one that a collision is with. Their sum along a
// flight is found in lanes (render/walk).

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
template <class Share = WholeExtinction>
VoxelFibres chooseComponent(const YarnTables& yarns, const VoxelContent& content, const LocalDrape& drape,
                            glm::vec3 direction, float u, EventLaw law, const Share& share = {}) {
  int chosen = 0;
  if (hasSeveralComponents(content)) {
    std::array<float, 2 * VoxelContent::kMaxSpans> weights;
    int count = 0;
    float sum = 0;
    forEachComponent(yarns, content, drape, [&](const VoxelFibres& component) {
      const float weight = law == EventLaw::report
                               ? component.fibres.lengthDensity
                               : extinction(component.fibres, *component.optics, direction) * share(component);
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

}  // namespace loomlight
