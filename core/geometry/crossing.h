#pragma once

#include "core/geometry/yarn_geometry.h"
#include "core/geometry/yarn_path.h"

namespace loomlight {

/// How a warp and a weft yarn pass each other where they cross: the axis of the upper lies at `height` above the
/// mid-plane, that of the lower at its own height below, each bending about the other.
struct Crossing {
  double warpHeight_mm = 0, weftHeight_mm = 0;
  double warpRadius_mm = 0, weftRadius_mm = 0;  ///< of the arc: own half-height and half the other's thinner side
  double warpFlat_mm = 0, weftFlat_mm = 0;      ///< half-length of the flat over the other's flattened section
  bool operator==(const Crossing&) const = default;
};

/// The yarns touch, and their crowns are level: warp height + weft height = both half-heights, and the cloth is as thin
/// as it can be, the way finishing presses it; so thin yarns bend round thick ones. Where the pitch of one system is
/// too short for arcs of that height (Peirce's jamming), the other bends more; where both are, radii shrink and the
/// yarns press into each other, up to kSteepestPath; beyond that they no longer touch on the right side of each other.
Crossing cross(const YarnGeometry& warp, const YarnGeometry& weft);

/// How much a float bulges, mm, at a crossing that is `distance` crossings from the nearest end of the float.
double floatRise_mm(const YarnGeometry& yarn, int distance);
/// Distances from here on rise no further: what keeps the number of distinct cells small.
inline constexpr int kMaxFloatDistance = 3;

}  // namespace loomlight
