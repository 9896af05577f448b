#pragma once

#include <array>

#include "core/geometry/yarn_geometry.h"
#include "core/geometry/yarn_path.h"

namespace loomlight {

/// How a warp and a weft yarn pass each other where they cross: the axis of the upper lies at its height above the
/// mid-plane, that of the lower at its own below. By the float state of the yarn itself.
struct Crossing {
  std::array<double, kFloatStates> warpHeight_mm{}, weftHeight_mm{};
  bool operator==(const Crossing&) const = default;
};

/// The yarns rest on each other, and share the height by how readily they bend: stiffness goes by the square of the
/// mass (equal fibres), what a length between crossings yields by its power of 2.5, between bending (3) and tension
/// (1). `balance` (1) multiplies the warp's share against the weft's. No yarn climbs steeper than kSteepestPath: where
/// the pitch of one is too short the other bends more, and where both are, they press into each other.
Crossing cross(const YarnGeometry& warp, const YarnGeometry& weft, double balance);

}  // namespace loomlight
