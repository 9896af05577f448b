#pragma once

#include <array>

#include "core/geometry/yarn/yarn_geometry.h"
#include "core/geometry/yarn/yarn_path.h"

namespace loomlight {

/// How a warp and a weft yarn pass each other where they cross: the axis of the upper lies at its height above the
/// mid-plane, that of the lower at its own below. By the float states of the yarn itself and of the one that it
/// crosses.
struct Crossing {
  using Heights = std::array<std::array<double, kFloatStates>, kFloatStates>;
  Heights warpHeight_mm{}, weftHeight_mm{};
  bool operator==(const Crossing&) const = default;
};

/// The yarns rest on each other, and share the height by how hard each is to lift: a beam under the loom's tension over
/// its pitch, whose bending counts for most where it bends both ways, and for little where a float begins. Inside a
/// float each rises by itself, whatever it crosses, as far as its section and finish say, and no lower than at the
/// float's ends. `balance` (1) multiplies the warp's share against the weft's. No yarn climbs steeper than
/// kSteepestPath: where the pitch of one is too short the other bends more, and where both are, they press into each
/// other. The law was found on relaxed yarns (tests/bench/relaxation.h), of which half were not used for it.
Crossing cross(const YarnGeometry& warp, const YarnGeometry& weft, double balance);

}  // namespace loomlight
