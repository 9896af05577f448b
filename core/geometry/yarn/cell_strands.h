#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/units.h"
#include "core/geometry/yarn/stations.h"
#include "core/geometry/yarn/yarn_model.h"
#include "core/geometry/yarn/yarn_path.h"

namespace loomlight {

/// The fibres of one cell, as polylines. Local frame, mm: s along the yarn in [-pitch/2, pitch/2], u across it, z up;
/// u = s x z. For the warp (s, u) = (+y, +x); for the weft (s, u) = (+x, -y). Stored as vec3(u, s, z). Every point lies
/// in |u| <= 1.5 crossPitch: a yarn may spill into the cells beside its own, never further. A fibre that leaves the
/// cell at s = pitch/2 goes on in the next cell of the yarn at s = -pitch/2.
struct CellStrands {
  struct Strand {
    uint32_t first = 0;  ///< into points
    uint32_t count = 0;  ///< points, >= 2; segments = count - 1
    uint8_t ply = 0;     ///< among the plies of all cords
    bool loose = false;  ///< a hair, which stands off the yarn's body
  };
  std::vector<glm::vec3> points;
  std::vector<Strand> strands;
  /// What each weighs, over a fibre of the yarn: above 1 where an uneven yarn is thick. There the yarn has more fibres;
  /// statistics count each line as so many of the yarn's own radius, and where lines themselves are traced they are as
  /// much thicker.
  float fibresEach = 1;
  /// The yarn's, but for the percent or two (0.3 % in open cloth) by which bending and the cell's own length change the
  /// take-up of the twist: with this radius the cell weighs the yarn's count times the length of its axis, exactly; of
  /// an uneven yarn, times what its stretch has of the count there.
  float fibreRadius_mm = 0;

  size_t segments() const { return points.size() - strands.size(); }
  double length_mm() const;  ///< of all fibres
};

/// The fibres of a yarn in a cell: fibres wound about the axes of their plies, plies about their cord's, cords about
/// the yarn's, migrating between core and surface (Zhao et al. 2016, Eq. 3), then pressed, and cut off at the ends of
/// the cell. Every fibre's points lie at the cell's stations (stations.h). With the yarn's own fibre radius.
CellStrands layStrands(const YarnModel& yarn, const PathNode& previous, const PathNode& here, const PathNode& next,
                       const CellOfYarn& cell, double pitch_mm);

}  // namespace loomlight
