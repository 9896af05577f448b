#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry/yarn/discs.h"

namespace loomlight::test {

/// Deepest overlap of any two fibres of a section, in radii; 0 where all are apart. Looks at every pair.
inline double worstOverlap(const DiscCentres& centres_mm, const HelicalFibres& fibres) {
  double worst = 0;
  for (size_t i = 0; i < centres_mm.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      worst = std::max(worst, 2 * fibres.radius_mm - std::sqrt(fibres.apartSquare(centres_mm[i], centres_mm[j])));
  return worst / fibres.radius_mm;
}

}  // namespace loomlight::test
