#pragma once

#include "core/shell/shell.h"
#include "render/media/known_fibre.h"
#include "render/walk/walk_lanes.h"

namespace loomlight {

// What a path knows, and vectors in general, put into the columns of one lane.

inline void put(LaneFloats (&columns)[3], size_t lane, glm::vec3 v) {
  for (int axis = 0; axis < 3; ++axis) columns[axis][lane] = v[axis];
}
inline void put(LaneInts (&columns)[3], size_t lane, glm::ivec3 v) {
  for (int axis = 0; axis < 3; ++axis) columns[axis][lane] = v[axis];
}

/// CellLanes::Slot::yarn.
inline int32_t numberOf(YarnId yarn) {
  return 2 * yarn.index + static_cast<int32_t>(yarn.system);
}

/// `origin`: where the lane's ray is at t = 0, in the world.
inline void putPastSegments(KnownLanes& lanes, size_t lane, const KnownFibres& known, glm::vec3 origin) {
  for (size_t i = 0; i < known.pastSegments.size(); ++i) {
    const RaySegment& past = known.pastSegments[i];
    KnownLanes::PastSegment& columns = lanes.pastSegments[i];
    put(columns.offset_mm, lane, origin - past.end);
    put(columns.direction, lane, past.direction);
    columns.length_mm[lane] = past.length_mm;
  }
}

/// How a fibre lies in cloth space.
struct FibreInCloth {
  glm::vec3 toAxis_mm, tangent;

  /// Seen from a place of the world in that tetrahedron of the shell.
  FibreInCloth(const KnownFibre& fibre, glm::vec3 from, const Shell& shell, int tet)
      : toAxis_mm(fibre.axis - from), tangent(fibre.tangent) {
    if (shell.isFlat()) return;
    const glm::mat3& toCloth = shell.tets()[tet].toCloth;
    toAxis_mm = toCloth * toAxis_mm;
    tangent = glm::normalize(toCloth * tangent);
  }
};

/// The fibre before, but for where its axis is.
inline void putBefore(KnownLanes::Before& lanes, size_t lane, const KnownFibre& before, const FibreInCloth& inCloth) {
  put(lanes.tangent, lane, inCloth.tangent);
  lanes.radius_mm[lane] = before.radius_mm;
  lanes.yarn[lane] = numberOf(before.yarnId);
}

}  // namespace loomlight
