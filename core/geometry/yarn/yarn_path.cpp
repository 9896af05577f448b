#include "core/geometry/yarn/yarn_path.h"

#include <algorithm>
#include <cmath>

// How it works. From one crossing to the next an axis goes along an arc, a straight line and the arc turned over, each
// a third of the way, horizontal at both ends. The line's slope is that which climbs from height to height, found by
// Newton's method; lengths along the path and places on it are then closed forms.

namespace loomlight {
namespace {

AxisPoint advance(const AxisPoint& p, double length_mm, double curvature_per_mm) {
  if (curvature_per_mm == 0)
    return {p.s_mm + length_mm * std::cos(p.angle), p.z_mm + length_mm * std::sin(p.angle), p.angle};
  const double angle = p.angle + curvature_per_mm * length_mm;
  return {p.s_mm + (std::sin(angle) - std::sin(p.angle)) / curvature_per_mm,
          p.z_mm + (std::cos(p.angle) - std::cos(angle)) / curvature_per_mm, angle};
}

constexpr double kArcShare = 1.0 / 3;  // of the span

/// How high a path climbs over a unit of span whose line has this slope, and how that grows with the slope. An arc
/// from the horizontal to the angle a rises by tan(a / 2) over a unit.
struct Climb {
  double height, growth;
  explicit Climb(double slope) {
    const double secant = std::sqrt(1 + slope * slope), half = slope / (1 + secant);
    height = 2 * kArcShare * half + (1 - 2 * kArcShare) * slope;
    growth = kArcShare * (1 + half * half) / (secant * secant) + 1 - 2 * kArcShare;
  }
};

/// The slope of the line that climbs so high over a unit of span. The climb is concave in the slope, so Newton's steps
/// come up to it from below.
double slopeOf(double height) {
  double slope = 0;
  for (int i = 0; i < 12; ++i) {
    const Climb climb(slope);
    slope += (height - climb.height) / climb.growth;
  }
  return std::min(slope, std::tan(kSteepestPath));
}

}  // namespace

double steepestClimb_mm(double span_mm) {
  return span_mm * Climb(std::tan(kSteepestPath)).height;
}

Transition::Transition(const PathNode& from, const PathNode& to, double span_mm) {
  const double climb = static_cast<double>(to.height_mm) - from.height_mm;
  const double angle = std::atan(slopeOf(std::abs(climb) / span_mm)), up = climb < 0 ? -1.0 : 1.0;
  end_ = {0.0, from.height_mm, 0.0};
  if (angle < 1e-9) {
    append(span_mm, 0.0);
    return;
  }
  const double arc_mm = kArcShare * span_mm;
  const double curvature = up * std::sin(angle) / arc_mm;
  const double arcLength_mm = arc_mm * angle / std::sin(angle);
  append(arcLength_mm, curvature);
  append((span_mm - 2 * arc_mm) / std::cos(angle), 0.0);
  append(arcLength_mm, -curvature);
}

void Transition::append(double length_mm, double curvature_per_mm) {
  if (!(length_mm > 1e-12)) return;
  pieces_[count_++] = {end_, length_mm_, length_mm, curvature_per_mm};
  end_ = advance(end_, length_mm, curvature_per_mm);
  length_mm_ += length_mm;
}

AxisPoint Transition::at(double length_mm) const {
  if (length_mm >= length_mm_) return end_;
  size_t i = 0;
  while (i + 1 < count_ && length_mm >= pieces_[i + 1].begin_mm) ++i;
  return advance(pieces_[i].start, length_mm - pieces_[i].begin_mm, pieces_[i].curvature_per_mm);
}

double Transition::lengthTo(double s_mm) const {
  size_t i = 0;
  while (i + 1 < count_ && s_mm >= pieces_[i + 1].start.s_mm) ++i;
  const Piece& piece = pieces_[i];
  const double ds = s_mm - piece.start.s_mm;
  if (piece.curvature_per_mm == 0) return piece.begin_mm + ds / std::cos(piece.start.angle);
  const double sine = std::clamp(std::sin(piece.start.angle) + piece.curvature_per_mm * ds, -1.0, 1.0);
  return piece.begin_mm + (std::asin(sine) - piece.start.angle) / piece.curvature_per_mm;
}

}  // namespace loomlight
