#pragma once

#include "core/base/units.h"

namespace loomlight {

/// A point that moves: its place, and the first and second derivative of it.
struct Motion {
  glm::dvec2 at{0}, velocity{0}, acceleration{0};
  /// In a frame that turns about the origin, as who does not turn sees it: `rate` radians from x to y.
  Motion turning(double rate) const;
};

/// How plies give way to one another where they are twisted together: they flatten where they touch, two of them so
/// that no gap is left between them but a crevice on either side. Wires stay round. It takes places in a round ply to
/// where they lie in the yarn, and keeps areas: as densely as fibres lie in the one, they lie in the other. All lengths
/// are in mm.
class PlyShape {
 public:
  PlyShape(int plies, double radius_mm, bool isWire);

  /// Of a place in the round ply, from its middle, where it lies from the axis of all plies: x outwards, y around, in
  /// the frame that turns with the ply. So does the place.
  glm::vec2 place(glm::vec2 inPly) const {
    return {orbit_ + outwards_ * inPly.x - bulge_ * inPly.y * inPly.y, around_ * inPly.y};
  }
  Motion place(const Motion& inPly) const;
  double orbit_mm() const { return orbit_; }  ///< of the ply's middle
  /// Of the round yarn that others rest on: as large as a single of the plies' area, where they fill one. Plies stand
  /// out of it by an eighth where they are farthest.
  double radius_mm() const { return radius_; }
  /// How far from the axis of all plies a place may lie that is so far from the middle of its own.
  double reach_mm(double inPly_mm) const;
  /// Half the width of all plies as one sees it from a side, on average as they turn, where each is so wide.
  double silhouette_mm(double inPly_mm) const;
  /// The most by which it draws two places apart that are near each other and no farther than that from the middle.
  double stretch(double inPly_mm) const;

 private:
  template <class Visit>
  double largestOnRim(double inPly_mm, const Visit& visit) const;

  float orbit_ = 0, outwards_ = 1, around_ = 1;
  float bulge_ = 0;  ///< per mm
  double radius_ = 0;
  int plies_ = 1;
};

}  // namespace loomlight
