#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/volume/pool/tangent_spread.h"
#include "core/volume/traverse/cloth_volume.h"
#include "render/media/cloth_walk.h"
#include "render/media/medium.h"

namespace loomlight {

// What a ray meets in one voxel: the sum over its components, which is all that a flight asks for, and the component
// that a collision is with.

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

/// Calls visit(fibres in the world, const YarnOptics&, const VoxelContent::YarnSpan&) for each component of a voxel.
template <class Visit>
void forEachComponent(const YarnTables& yarns, const VoxelContent& content, const LocalDrape& drape, Visit&& visit) {
  for (int p = 0; p < content.count; ++p) {
    const VoxelContent::YarnSpan& span = content.spans[p];
    const YarnOptics& optics = yarns[static_cast<int>(span.system)][span.yarn];
    for (const Component& component : span.components) visit(inWorld(component.decode(), drape), optics, span);
  }
}

/// The share of a component's extinction that counts: all of it. Others are functions of the same arguments.
struct WholeExtinction {
  float operator()(const FibreDistribution&, const YarnOptics&, const VoxelContent::YarnSpan&) const { return 1; }
};

/// Sums over the components of a voxel.
struct VoxelExtinction {
  float total = 0;  ///< extinction, 1/mm, of which each component counts with its share
  float whole = 0;  ///< extinction, 1/mm
  float solid = 0;  ///< how much of the voxel is fibre, 0.. (overlapping fibres count twice)
  float kept = 0;   ///< the same, that other fibres keep out of: by the separation of each yarn
};

/// Cost: about one decoding, one dot product and one table look-up a component.
template <class Share = WholeExtinction>
VoxelExtinction sumExtinction(const YarnTables& yarns, const VoxelContent& content, const LocalDrape& drape,
                              glm::vec3 direction, const Share& share = {}) {
  VoxelExtinction sum;
  forEachComponent(yarns, content, drape,
                   [&](const FibreDistribution& fibres, const YarnOptics& optics, const VoxelContent::YarnSpan& span) {
                     const float whole = extinction(fibres, optics, direction);
                     sum.total += whole * share(fibres, optics, span);
                     sum.whole += whole;
                     const float solid =
                         static_cast<float>(kPi) * optics.fibreRadius_mm * optics.fibreRadius_mm * fibres.lengthDensity;
                     sum.solid += solid;
                     sum.kept += solid * optics.separation;
                   });
  return sum;
}

/// Where in a voxel with content its fibres lie: around the boxes of all its components, for which all of them count as
/// spread over it.
inline VoxelBox boxOf(const VoxelContent& content) {
  VoxelBox box = content.spans[0].components[0].box();
  for (int span = 0; span < content.count; ++span)
    for (const Component& component : content.spans[span].components) box = around(box, component.box());
  return box;
}

/// The fibres that a collision is with.
struct MetComponent {
  FibreDistribution fibres;  ///< in the world
  const YarnOptics* optics;
  YarnId yarnId;
  int yarn;  ///< index into Fabric::yarns
};

/// Whether it takes a choice which component of a voxel with content is met.
inline bool hasSeveralComponents(const VoxelContent& content) {
  return content.count > 1 || content.spans[0].components.size() > 1;
}

/// Of a voxel with content, in proportion to what counts of extinction; u in [0, 1). EventLaw::report chooses by
/// density alone (Eq. 12), which is biased where components are seen at different angles.
template <class Share = WholeExtinction>
MetComponent chooseComponent(const YarnTables& yarns, const VoxelContent& content, const LocalDrape& drape,
                             glm::vec3 direction, float u, EventLaw law, const Share& share = {}) {
  int chosen = 0;
  if (hasSeveralComponents(content)) {
    std::array<float, 2 * VoxelContent::kMaxSpans> weights;
    int count = 0;
    float sum = 0;
    forEachComponent(
        yarns, content, drape,
        [&](const FibreDistribution& fibres, const YarnOptics& optics, const VoxelContent::YarnSpan& span) {
          const float weight = law == EventLaw::report
                                   ? fibres.lengthDensity
                                   : extinction(fibres, optics, direction) * share(fibres, optics, span);
          weights[count++] = weight;
          sum += weight;
        });
    for (float rest = u * sum; chosen + 1 < count; ++chosen) {
      rest -= weights[chosen];
      if (rest < 0) break;
    }
  }
  MetComponent met{};
  int number = 0;
  forEachComponent(yarns, content, drape,
                   [&](const FibreDistribution& fibres, const YarnOptics& optics, const VoxelContent::YarnSpan& span) {
                     if (number++ == chosen) met = {fibres, &optics, {span.system, span.index}, span.yarn};
                   });
  return met;
}

}  // namespace loomlight
