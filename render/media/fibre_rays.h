#pragma once

#include <memory>
#include <optional>

#include "render/media/medium.h"
#include "render/scene/fibre_hit.h"

namespace loomlight {

class FibreBvh;

/// The fibre that light leaves, which it does not see near where it sets out.
struct OwnFibre {
  uint64_t fibre = 0;      ///< FibreHit::fibre; 0: none
  float clearance_mm = 0;  ///< within this distance it is not met again
};

/// Explicit fibres, as rays in the world ask for them; for one thread.
class FibreRays {
 public:
  /// A fibre, and where it was met.
  struct Met {
    FibreHit hit;  ///< in the world
    ScenePoint place;
  };
  virtual ~FibreRays() = default;
  virtual std::optional<Met> meet(const ScenePoint& from, glm::vec3 direction, const OwnFibre& own) = 0;
  virtual bool isFree(const ScenePoint& from, glm::vec3 direction, float distance, const OwnFibre& own) = 0;
};

/// Of every strand of a piece, laid in one tree. It must outlive them.
std::unique_ptr<FibreRays> raysInto(const FibreBvh& bvh);
/// Of the bricks of a cloth that has any (TraceData::fibres), which must outlive them.
std::unique_ptr<FibreRays> raysIntoBricks(const TraceData& cloth);

}  // namespace loomlight
