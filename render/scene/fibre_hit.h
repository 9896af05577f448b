#pragma once

#include <cstdint>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Where a ray meets a fibre.
struct FibreHit {
  float distance_mm = 0;
  glm::vec3 normal{0, 0, 1};   ///< of the fibre's surface, unit
  glm::vec3 tangent{1, 0, 0};  ///< unit
  float radius_mm = 0;         ///< of the fibre there
  System system = System::warp;
  int end = 0, pick = 0;
  uint64_t fibre = 0;  ///< which of the whole cloth; never 0
};

/// The number of a fibre: `strand` of its cell, the same in every cell of that end or pick.
inline uint64_t fibreNumber(System system, int index, uint32_t strand) {
  const uint64_t yarn = uint64_t{2} * static_cast<uint32_t>(index) + (system == System::warp ? 0 : 1);
  return (yarn + 1) << 32 | strand;
}

}  // namespace loomlight
