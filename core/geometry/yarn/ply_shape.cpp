#include "core/geometry/yarn/ply_shape.h"

#include <algorithm>
#include <cmath>

// How it works. A ply becomes an ellipse, narrower outwards and as much wider around, and each two of these touch: on
// the line between two of n neighbours an ellipse of half-axes a and b, its middle at d, has its tangent where
// d^2 = a^2 + b^2 / tan^2(pi / n). Where there are two, each is sheared inwards by the square of the way around as
// well: then the side that faces the other ply is flat to the fourth order. Both maps have a determinant of 1.

namespace loomlight {

PlyShape::PlyShape(int plies, double radius_mm, bool areWires) : plies_(plies) {
  if (plies == 1) return;
  // A guess: where two fill the circle (0.71) yarns look like ribbons, round ones (1) run through those that they
  // cross.
  constexpr double kNarrower = 0.8;
  const double narrower = areWires || plies > 4 ? 1.0 : kNarrower;
  const double cotangent = plies == 2 ? 0.0 : 1 / std::tan(kPi / plies);
  const double orbit = radius_mm * std::hypot(narrower, cotangent / narrower);
  orbit_ = static_cast<float>(orbit);
  outwards_ = static_cast<float>(narrower);
  around_ = static_cast<float>(1 / narrower);
  bulge_ = plies == 2 && !areWires ? static_cast<float>(0.5 * narrower / radius_mm) : 0.0f;
}

Motion PlyShape::place(const Motion& p) const {
  const double out = outwards_, around = around_, bulge = bulge_;
  return {{orbit_ + out * p.at.x - bulge * p.at.y * p.at.y, around * p.at.y},
          {out * p.velocity.x - 2 * bulge * p.at.y * p.velocity.y, around * p.velocity.y},
          {out * p.acceleration.x - 2 * bulge * (p.velocity.y * p.velocity.y + p.at.y * p.acceleration.y),
           around * p.acceleration.y}};
}

template <class Visit>
double PlyShape::largestOnRim(double inPly_mm, const Visit& visit) const {
  constexpr int kSteps = 49;
  double most = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = kPi * i / (kSteps - 1);  // either side is the other's mirror image
    most = std::max(most, visit(place(Motion{inPly_mm * glm::dvec2(std::cos(angle), std::sin(angle))}).at));
  }
  return most;
}

double PlyShape::reach_mm(double inPly_mm) const {
  if (plies_ == 1) return inPly_mm;
  return largestOnRim(inPly_mm, [](glm::dvec2 at) { return glm::length(at); });
}

double PlyShape::silhouette_mm(double inPly_mm) const {
  if (plies_ == 1) return inPly_mm;
  constexpr int kDirections = 12;
  double sum = 0;
  for (int i = 0; i < kDirections; ++i) {  // those in which this ply stands out farther than the others
    const double angle = kPi / plies_ * (i + 0.5) / kDirections;
    const glm::dvec2 side(std::cos(angle), std::sin(angle));
    sum += largestOnRim(inPly_mm, [side](glm::dvec2 at) { return glm::dot(at, side); });
  }
  return sum / kDirections;
}

double PlyShape::stretch(double inPly_mm) const {
  // The larger singular value of a matrix with determinant 1, from the sum of its squares.
  const double shear = 2 * bulge_ * inPly_mm, out = outwards_, around = around_;
  const double half = 0.5 * (out * out + around * around + shear * shear);
  return std::sqrt(half + std::sqrt(std::max(0.0, half * half - 1)));
}

}  // namespace loomlight
