#pragma once

#include "render/media/medium.h"
#include "render/scene/fibre_hit.h"

namespace loomlight {

/// The scattering event of a ray, in direction `direction`, that has come to the surface of an explicit fibre there.
Collision collisionAt(const TraceData& cloth, const ScenePoint& place, glm::vec3 direction, const FibreHit& hit);

}  // namespace loomlight
