#include "render/media/volume_medium.h"

#include <algorithm>
#include <cmath>

#include "render/media/batch_of.h"
#include "render/media/cloth_walk.h"
#include "render/media/fibre_tangent.h"
#include "render/media/voxel_extinction.h"

namespace loomlight {

std::unique_ptr<MediumBatch> VolumeMedium::batch(size_t paths) const {
  return std::make_unique<BatchOf<VolumeMedium>>(*this, paths);
}

std::optional<Collision> VolumeMedium::collide(const ScenePoint& from, Memory&, glm::vec3 direction, Random& random,
                                               TraceCounts& counts) const {
  float opticalDepth = -std::log(1 - random.uniform());
  ++counts.rays;
  ClothWalk walk(*cloth_, from, direction, std::numeric_limits<float>::infinity());
  while (walk.next()) {
    ++counts.steps;
    const float total = sumExtinction(cloth_->yarns, walk.content(), walk.drape(), direction);
    const float depth = total * (walk.leave() - walk.enter());
    if (opticalDepth >= depth) {
      opticalDepth -= depth;
      continue;
    }
    const float t = std::min(walk.leave(), walk.enter() + opticalDepth / total);
    const VoxelFibres met =
        chooseComponent(cloth_->yarns, walk.content(), walk.drape(), direction, random.uniform(), law_);
    Collision c;
    c.place = {from.world + t * direction, walk.tet()};
    c.distance_mm = t;
    c.incoming = direction;
    if (law_ == EventLaw::report) {
      const float u1 = random.uniform(), u2 = random.uniform();
      c.tangent = sampleTangent(met.fibres, u1, u2) * eitherWay(random);
    } else {
      c.tangent = projectedTangent(met.fibres, direction, random) * eitherWay(random);
    }
    c.offset = 2.0f * random.uniform() - 1.0f;
    c.normal = walk.drape().normal();
    c.optics = *met.optics;
    c.radius_mm = c.optics.fibreRadius_mm;
    c.material = drawMaterial(c.optics, random);
    c.yarnId = met.yarnId();
    c.yarn = met.span->yarn;
    c.end = walk.content().end;
    c.pick = walk.content().pick;
    return c;
  }
  return std::nullopt;
}

float VolumeMedium::transmittanceBeyond(float clear_mm, const ScenePoint& from, glm::vec3 direction, float distance,
                                        Random& random, TraceCounts& counts) const {
  constexpr float kExactDepth = 4.0f;
  const float deepest = kExactDepth - std::log(1 - random.uniform());
  float depth = 0;
  ++counts.rays;
  ClothWalk walk(*cloth_, from, direction, distance);
  while (walk.next()) {
    const float length = walk.leave() - std::max(walk.enter(), clear_mm);
    if (length <= 0) continue;
    ++counts.steps;
    depth += sumExtinction(cloth_->yarns, walk.content(), walk.drape(), direction) * length;
    if (!(depth < deepest)) return 0;
  }
  return std::exp(-std::min(depth, kExactDepth));
}

}  // namespace loomlight
