#pragma once

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Cloth coordinates of a point of CellStrands whose cell has this centre.
inline glm::vec3 inCloth(glm::vec3 usz, System system, glm::vec2 centre_mm) {
  return system == System::warp ? glm::vec3(centre_mm.x + usz.x, centre_mm.y + usz.y, usz.z)
                                : glm::vec3(centre_mm.x + usz.y, centre_mm.y - usz.x, usz.z);
}

}  // namespace loomlight
