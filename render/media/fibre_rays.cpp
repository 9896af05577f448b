#include "render/media/fibre_rays.h"

#include <limits>

#include "render/media/shell_walk.h"
#include "render/scene/fibre_bricks.h"
#include "render/scene/fibre_bvh.h"

// How it works. Among the fibres of a piece that is laid as a whole, a ray is one query of its tree, in world space.
// Among bricks, a ray goes through the shell, in each tetrahedron of which it is straight in cloth space too, with
// the path parameter unchanged; there the bricks of each cell are asked, and what is met is bent back into the
// world: tangents by the drape, normals by its inverse transpose.

namespace loomlight {
namespace {

class RaysIntoTree final : public FibreRays {
 public:
  explicit RaysIntoTree(const FibreBvh& bvh) : bvh_(bvh) {}

  std::optional<Met> meet(const ScenePoint& from, glm::vec3 direction, const OwnFibre& own) override {
    const auto hit = bvh_.meet(
        {.origin = from.world, .direction = direction, .ownFibre = own.fibre, .clearance_mm = own.clearance_mm});
    if (!hit) return std::nullopt;
    return Met{*hit, {from.world + hit->distance_mm * direction, -1}};
  }
  bool isFree(const ScenePoint& from, glm::vec3 direction, float distance, const OwnFibre& own) override {
    return bvh_.isFree({from.world, direction, distance, own.fibre, own.clearance_mm});
  }

 private:
  const FibreBvh& bvh_;
};

/// Walks through the shell, in each tetrahedron of which rays are straight in cloth space too.
class RaysIntoBricks final : public FibreRays {
 public:
  explicit RaysIntoBricks(const TraceData& cloth) : cloth_(cloth), reader_(*cloth.fibres, *cloth.volume) {}

  std::optional<Met> meet(const ScenePoint& from, glm::vec3 direction, const OwnFibre& own) override {
    ShellWalk walk(cloth_, from, direction, std::numeric_limits<float>::infinity());
    while (walk.next()) {
      const ShellSegment& s = walk.segment();
      const auto hit = reader_.meet(rayIn(s, own));
      if (!hit) continue;
      const FibreHit met = inWorld(*hit, s);
      return Met{met, {from.world + met.distance_mm * direction, s.tet}};
    }
    return std::nullopt;
  }
  bool isFree(const ScenePoint& from, glm::vec3 direction, float distance, const OwnFibre& own) override {
    ShellWalk walk(cloth_, from, direction, distance);
    while (walk.next())
      if (!reader_.isFree(rayIn(walk.segment(), own))) return false;
    return true;
  }

 private:
  static ClothRay rayIn(const ShellSegment& s, const OwnFibre& own) {
    return {s.clothOrigin, s.clothDirection, s.tEnter, s.tLeave, own.fibre, own.clearance_mm - s.passed};
  }

  FibreHit inWorld(FibreHit hit, const ShellSegment& s) const {
    hit.distance_mm += s.passed;
    if (cloth_.shell->isFlat()) return hit;
    hit.tangent = glm::normalize(s.drape.frame * hit.tangent);
    const glm::vec3 normal = glm::transpose(cloth_.shell->tets()[static_cast<size_t>(s.tet)].toCloth) * hit.normal;
    hit.normal = glm::normalize(normal - glm::dot(normal, hit.tangent) * hit.tangent);
    return hit;
  }

  const TraceData& cloth_;
  FibreBricks::Reader reader_;
};

}  // namespace

std::unique_ptr<FibreRays> raysInto(const FibreBvh& bvh) {
  return std::make_unique<RaysIntoTree>(bvh);
}

std::unique_ptr<FibreRays> raysIntoBricks(const TraceData& cloth) {
  return std::make_unique<RaysIntoBricks>(cloth);
}

}  // namespace loomlight
