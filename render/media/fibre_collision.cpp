#include "render/media/fibre_collision.h"

#include <algorithm>
#include <cmath>

#include "render/media/fibre_tangent.h"

namespace loomlight {

Collision collisionAt(const TraceData& cloth, const ScenePoint& place, glm::vec3 direction, const FibreHit& hit) {
  Collision c;
  c.place = place;
  c.distance_mm = hit.distance_mm;
  c.incoming = direction;
  Random root(~hit.fibre);  // apart from the number that decides its material
  c.tangent = hit.tangent * eitherWay(root);
  const glm::vec3 across = glm::cross(c.tangent, direction);
  // h is the sine, about the axis, from the normal to the way back.
  const float width = glm::length(across);
  c.offset = width > 0 ? std::clamp(glm::dot(across, hit.normal) / width, -1.0f, 1.0f) : 0.0f;
  c.normal = hit.normal;
  c.fibre = hit.fibre;
  c.end = hit.end;
  c.pick = hit.pick;
  c.yarnId = {hit.system, hit.system == System::warp ? hit.end : hit.pick};
  c.yarn = cloth.volume->geometry().yarnIndex(c.yarnId.system, c.yarnId.index);
  c.optics = cloth.yarns[static_cast<int>(hit.system)][c.yarn];
  c.radius_mm = hit.radius_mm;
  c.axis = c.place.world - c.radius_mm * hit.normal;
  Random kind(mixBits(hit.fibre));  // a fibre is what it is, whoever meets it
  c.material = drawMaterial(c.optics, kind);
  return c;
}

}  // namespace loomlight
