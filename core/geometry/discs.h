#pragma once

#include <vector>

#include "core/base/units.h"

namespace loomlight {

/// Discs of equal size in a plane, by their centres.
using DiscCentres = std::vector<glm::dvec2>;

/// Moves apart, half each, every two discs of that diameter that overlap; the deepest overlap that was met. One sweep:
/// chains of contacts need many.
double pushApart(DiscCentres& centres, double diameter);

/// Deepest overlap of any two discs, in radii; 0 where all are apart.
double worstOverlap(const DiscCentres& centres_mm, double radius_mm);

}  // namespace loomlight
