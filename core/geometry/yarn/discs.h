#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/base/simd.h"
#include "core/base/units.h"
#include "core/geometry/yarn/pressing.h"
#include "core/geometry/yarn/turning.h"

namespace loomlight {

/// Discs of equal size in a plane, by their centres.
using DiscCentres = std::vector<glm::dvec2>;

/// Where a fibre lies in a section, from the axis, or where it lies in several sections side by side; mm.
template <class T>
struct PlaceOf {
  T up, across;
};
using PlaceLanes = PlaceOf<Float32x8>;

/// turned() (turning.h) for one place, or for several side by side.
template <class T>
PlaceOf<T> turned(glm::dvec2 direction, const PlaceOf<T>& p) {
  const T along = broadcast<T>(direction.x), aside = broadcast<T>(direction.y);
  return {along * p.up - aside * p.across, aside * p.up + along * p.across};
}

/// Eight sections of the same fibres, fibre by fibre.
using SectionLanes = std::vector<PlaceLanes>;

/// `sections`: one to eight, of equally many fibres; the last one fills the lanes that are left.
SectionLanes sideBySide(std::span<const DiscCentres> sections);
DiscCentres sectionOf(const SectionLanes& sections, int lane);

/// Fibres, or plies, of one radius that all wind about the origin: a section cuts them not as discs but as ellipses,
/// the longer the way they turn the further out they lie, by 1 / cos of their helix angle. Their places are those in
/// the round section, (up, across); they touch as they lie in the pressed one.
struct HelicalFibres {
  double radius_mm = 0;
  double turns_per_mm = 0;  ///< of length along the axis; 0: they are straight
  SectionScale section{};   ///< that they turn in

  /// Square of the distance from one to another, as seen along them: the way around the origin is foreshortened by the
  /// cosine of the helix angle halfway between. They touch where that is two radii.
  template <class T>
  T apartSquare(const PlaceOf<T>& from, const PlaceOf<T>& to) const {
    const T up = broadcast<T>(section.up), across = broadcast<T>(section.across);
    const T halfTurn = broadcast<T>(kPi * turns_per_mm), one = broadcast<T>(1);
    const T betweenUp = up * (to.up - from.up), betweenAcross = across * (to.across - from.across);
    // The fibres' slope halfway, of both together; what is left of the distance is that across the slope.
    const T slopeUp = -halfTurn * up * (from.across + to.across), slopeAcross = halfTurn * across * (from.up + to.up);
    const T beside = slopeUp * betweenAcross - slopeAcross * betweenUp;
    return (betweenUp * betweenUp + betweenAcross * betweenAcross + beside * beside) /
           (one + slopeUp * slopeUp + slopeAcross * slopeAcross);
  }
  double apartSquare(glm::dvec2 from, glm::dvec2 to) const {
    return apartSquare(PlaceOf<double>{from.x, from.y}, PlaceOf<double>{to.x, to.y});
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

/// Draws fibres that lie farther out than `rim_mm` back to it.
void keepWithin(SectionLanes& sections, double rim_mm);

/// Moves the fibres of eight sections apart, each section by itself. It remembers which are neighbours until they have
/// moved too far: keep one for the same sections.
class Parting {
 public:
  explicit Parting(const HelicalFibres& fibres) : fibres_(fibres) {}
  /// One sweep: moves apart, half each, every two that overlap; the deepest overlap that was met, mm. Chains of
  /// contacts need many.
  double sweep(SectionLanes& sections);

 private:
  void findNeighbours(const SectionLanes& sections);
  bool knowsNeighbours(const SectionLanes& sections) const;

  HelicalFibres fibres_;
  double slack_mm_ = 0;  ///< that neighbours were looked for in, beyond where they touch
  SectionLanes looked_;  ///< where they were then
  std::vector<std::pair<int, int>> neighbours_;
};

}  // namespace loomlight
