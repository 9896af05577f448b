#pragma once

#include <cstdint>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/geometry/yarn/discs.h"

namespace loomlight {

/// Where the fibres of one ply lie in its section, mm from the ply's axis; their centroid is 0. A pure function of its
/// arguments; unfinished when stopped.
/// - random: uniform in the disc of plyRadius less the fibres' radius, overlaps allowed (the report);
/// - packed: threads of the fibres' radius (or more where they need the room) that do not overlap, disordered as far as
///   there is room: a hexagonal lattice of the density that the section has when pressed, shaken, then relaxed. The
///   rim may reach beyond plyRadius by about a fibre.
DiscCentres plySection(FibreLayout layout, int count, double plyRadius_mm, const HelicalFibres& fibres, uint64_t seed,
                       const Task& task = oneThread());

}  // namespace loomlight
