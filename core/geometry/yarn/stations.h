#pragma once

#include <vector>

#include "core/geometry/yarn/yarn_model.h"
#include "core/geometry/yarn/yarn_path.h"

namespace loomlight {

/// A section of a yarn, where all its fibres have a point: what they share there.
struct Station {
  float s_mm = 0, z_mm = 0;        ///< of the axis, in the frame of the cell
  float aside_mm = 0;              ///< likewise, across the cell from its middle
  float normalS = 0, normalZ = 1;  ///< direction of "up" in the section
  float up = 1, across = 1;        ///< factors on the places of its fibres
  float crown_mm = 0;              ///< of the axis, above the mid-plane, were it uppermost here and even
  float lift_mm = 0;               ///< by which a thick yarn's top lies higher than an even one's
  float spill_mm = 0;              ///< how far fibres of the body may lie from s along the yarn
  /// Directions that the turns have come to: of fibres in their ply, of plies in their cord, of cords in the yarn.
  glm::vec2 plyTurn{1, 0}, yarnTurn{1, 0}, cableTurn{1, 0};
  Migration::Moment migration;
  double t = 0;  ///< cells from the start of the period
};

/// Where fibres may be off the true curve, in fibre radii: the height of an arc above its chord. Station spacing keeps
/// to it in every piece of the path, for the outermost fibres; less well where a transition would need more than
/// kMaxStations, or a cell more than some kMaxPointsPerCell points: only where many fibres bend absurdly sharply.
inline constexpr double kSagitta = 0.1;
inline constexpr int kMaxStations = 1024;
inline constexpr int kLeastMaxStations = 32;

/// Which cell of its yarn is laid.
struct CellOfYarn {
  int phase = 0;
  Stretch stretch;
};

/// The stations of a cell from `previous` through `here` to `next`, in order, and those beside it whose fibres spill
/// in: the fibres lie in planes normal to the path, so the cell's ends cut them at different stations. Each transition
/// has its stations from its own nodes, so both cells that share a transition have the same stations in it.
std::vector<Station> layStations(const YarnModel& yarn, const PathNode& previous, const PathNode& here,
                                 const PathNode& next, const CellOfYarn& cell, double pitch_mm);

}  // namespace loomlight
