#include "render/media/volume_medium.h"

#include <algorithm>
#include <cmath>

#include "render/media/cloth_walk.h"
#include "render/media/fibre_tangent.h"
#include "render/media/path_through.h"
#include "render/media/voxel_extinction.h"

namespace loomlight {

std::unique_ptr<MediumPath> VolumeMedium::path() const {
  return std::make_unique<PathThrough<VolumeMedium>>(*this);
}

std::optional<Collision> VolumeMedium::collide(const ScenePoint& from, Memory&, glm::vec3 direction, Random& random,
                                               TraceCounts& counts) const {
  float opticalDepth = -std::log(1 - random.uniform());
  std::optional<Collision> collision;
  ++counts.rays;
  walkCloth(*cloth_, from, direction, std::numeric_limits<float>::infinity(),
            [&](const VoxelContent& content, float tEnter, float tLeave, const LocalDrape& drape, int tet) {
              ++counts.steps;
              const float total = sumExtinction(cloth_->yarns, content, drape, direction).total;
              const float depth = total * (tLeave - tEnter);
              if (opticalDepth >= depth) {
                opticalDepth -= depth;
                return true;
              }
              const float t = std::min(tLeave, tEnter + opticalDepth / total);
              const MetComponent met =
                  chooseComponent(cloth_->yarns, content, drape, direction, random.uniform(), law_);
              Collision c;
              c.place = {from.world + t * direction, tet};
              c.distance_mm = t;
              c.incoming = direction;
              if (law_ == EventLaw::report) {
                const float u1 = random.uniform(), u2 = random.uniform();
                c.tangent = eitherWay(sampleTangent(met.fibres, u1, u2), random);
              } else {
                c.tangent = eitherWay(projectedTangent(met.fibres, direction, random), random);
              }
              c.offset = 2.0f * random.uniform() - 1.0f;
              c.normal = drape.normal();
              c.optics = *met.optics;
              c.thread = met.thread;
              c.yarn = met.yarn;
              c.end = content.end;
              c.pick = content.pick;
              collision = c;
              return false;
            });
  if (collision) collision->material = drawMaterial(collision->optics, random);
  return collision;
}

float VolumeMedium::transmittanceBeyond(float clear_mm, const ScenePoint& from, glm::vec3 direction, float distance,
                                        Random& random, TraceCounts& counts) const {
  constexpr float kExactDepth = 4.0f;
  const float deepest = kExactDepth - std::log(1 - random.uniform());
  float depth = 0;
  ++counts.rays;
  const bool through =
      walkCloth(*cloth_, from, direction, distance,
                [&](const VoxelContent& content, float tEnter, float tLeave, const LocalDrape& drape, int) {
                  const float length = tLeave - std::max(tEnter, clear_mm);
                  if (length <= 0) return true;
                  ++counts.steps;
                  depth += sumExtinction(cloth_->yarns, content, drape, direction).total * length;
                  return depth < deepest;
                });
  return through ? std::exp(-std::min(depth, kExactDepth)) : 0.0f;
}

}  // namespace loomlight
