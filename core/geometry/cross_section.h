#pragma once

#include <cstdint>
#include <vector>

#include "core/fabric/fabric.h"

namespace loomlight {

/// Where the fibres of one ply lie in its section, mm from the ply's axis; their centroid is 0. A pure function of its
/// arguments.
/// - random: uniform in the disc of plyRadius - fibreRadius, overlaps allowed (the report);
/// - packed: discs of fibreRadius that do not overlap, disordered as far as there is room: a hexagonal lattice of the
///   density count * fibreRadius^2 / plyRadius^2, shaken, then relaxed. The rim may reach beyond plyRadius by about a
///   fibre.
std::vector<glm::dvec2> plySection(FibreLayout layout, int count, double plyRadius_mm, double fibreRadius_mm,
                                   uint64_t seed);

/// Deepest overlap of any two discs, in fibre radii; 0 where all are apart.
double worstOverlap(const std::vector<glm::dvec2>& centres_mm, double fibreRadius_mm);

}  // namespace loomlight
