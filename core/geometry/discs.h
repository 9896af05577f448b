#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "core/geometry/pressing.h"

namespace loomlight {

/// Discs of equal size in a plane, by their centres.
using DiscCentres = std::vector<glm::dvec2>;

/// Fibres, or plies, of one radius that all wind about the origin: a section cuts them not as discs but as ellipses,
/// the longer the way they turn the further out they lie, by 1 / cos of their helix angle. Their places are those in
/// the round section, (up, across); they touch as they lie in the pressed one.
struct HelicalFibres {
  double radius_mm = 0;
  double turns_per_mm = 0;  ///< of length along the axis; 0: they are straight
  SectionScale section{};   ///< that they turn in

  /// Square of the distance from one to another, as seen along them: the way around the origin is foreshortened by the
  /// cosine of the helix angle halfway between. They touch where that is two radii.
  double apartSquare(glm::dvec2 from, glm::dvec2 to) const {
    const glm::dvec2 middle = 0.5 * (from + to), scale(section.up, section.across), between = scale * (to - from);
    const glm::dvec2 slope = 2 * kPi * turns_per_mm * scale * glm::dvec2(-middle.y, middle.x);
    const double around = glm::dot(slope, between);
    return glm::dot(between, between) - around * around / (1 + glm::dot(slope, slope));
  }
  /// Of the helix angle, at the square of a distance from the axis.
  double cosineAt(double square_mm2) const {
    const double slope = 2 * kPi * turns_per_mm;
    return 1 / std::sqrt(1 + slope * slope * square_mm2);
  }
};

/// How much of a fibre's section lies in other fibres, over its own; two that share some both count. Of fibres laid
/// at random that is the share of the section that is fibre, of those that keep apart 0.
double meanOverlap(const DiscCentres& centres_mm, const HelicalFibres& fibres);

/// Moves the fibres of a section apart. It remembers which are neighbours until they have moved too far: keep one for
/// each section.
class Parting {
 public:
  explicit Parting(const HelicalFibres& fibres) : fibres_(fibres) {}
  /// One sweep: moves apart, half each, every two that overlap; the deepest overlap that was met, mm. Chains of
  /// contacts need many.
  double sweep(DiscCentres& centres_mm);

 private:
  void findNeighbours(const DiscCentres& centres);
  bool knowsNeighbours(const DiscCentres& centres) const;

  HelicalFibres fibres_;
  double slack_mm_ = 0;     ///< that neighbours were looked for in, beyond where they touch
  DiscCentres looked_;      ///< where they were then
  std::vector<int> order_;  ///< of the fibres, by where they lay
  std::vector<std::pair<int, int>> neighbours_;
};

}  // namespace loomlight
