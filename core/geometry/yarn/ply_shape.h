#pragma once

#include "core/base/units.h"
#include "core/geometry/yarn/turning.h"

namespace loomlight {

/// How plies give way to one another where they are twisted together: up to four become ovals that touch, flattened
/// towards the axis, two of them so that no gap is left between them but a crevice on either side. More than four hold
/// each other apart, and wires do not give way: these stay round. It takes places in a round ply to where they lie in
/// the yarn, and keeps areas: as densely as fibres lie in the one, they lie in the other. All lengths are in mm.
class PlyShape {
 public:
  PlyShape(int plies, double radius_mm, bool areWires);

  /// Takes a place in the round ply, from its middle, to where it lies from the axis of all plies. Both in the frame
  /// that turns with the ply: x points from the axis of all plies to the middle of this one, y around.
  glm::vec2 place(glm::vec2 inPly) const {
    return {orbit_ + outwards_ * inPly.x - bulge_ * inPly.y * inPly.y, around_ * inPly.y};
  }
  Motion place(const Motion& inPly) const;    ///< the same, of a place that moves
  double orbit_mm() const { return orbit_; }  ///< of the ply's middle
  /// How far from the axis of all plies a place may lie that is so far from the middle of its own.
  double reach_mm(double inPly_mm) const;
  /// Half the width of all plies as seen from a side, on average as they turn, where a place is so far from the middle
  /// of its own: as high does the topmost ply stand. Of two it is a fortieth more than the radius of their area.
  double silhouette_mm(double inPly_mm) const;
  /// The most by which it draws two places apart that are near each other and no farther than that from the middle.
  double stretch(double inPly_mm) const;
  /// How much it bends straight ways, at most: second derivative over the square of the first, per mm.
  double bend_per_mm() const { return 2 * bulge_; }

 private:
  /// The largest visit(place) of those so far from the middle of the ply.
  template <class Visit>
  double largestOnRim(double inPly_mm, const Visit& visit) const;

  float orbit_ = 0, outwards_ = 1, around_ = 1;
  float bulge_ = 0;  ///< per mm
  int plies_ = 1;
};

}  // namespace loomlight
