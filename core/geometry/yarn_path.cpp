#include "core/geometry/yarn_path.h"

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

AxisPoint advance(const AxisPoint& p, double length_mm, double curvature_per_mm) {
  if (curvature_per_mm == 0)
    return {p.s_mm + length_mm * std::cos(p.angle), p.z_mm + length_mm * std::sin(p.angle), p.angle};
  const double angle = p.angle + curvature_per_mm * length_mm;
  return {p.s_mm + (std::sin(angle) - std::sin(p.angle)) / curvature_per_mm,
          p.z_mm + (std::cos(p.angle) - std::cos(angle)) / curvature_per_mm, angle};
}

}  // namespace

Transition::Transition(const PathNode& from, const PathNode& to, double pitch_mm) {
  const double climb = static_cast<double>(to.height_mm) - from.height_mm;
  const double H = std::abs(climb);
  double radiusFrom = from.radius_mm, radiusTo = to.radius_mm;
  double R = radiusFrom + radiusTo;

  // Room E between the flats that two arcs of these radii need for the climb: they just meet at E^2 + H^2 = 2 H R, and
  // meet at the steepest angle at E = H / tan(steepest / 2).
  const double flats = static_cast<double>(from.flat_mm) + to.flat_mm;
  const double room = std::max(std::sqrt(std::max(0.0, H * (2 * R - H))), H / std::tan(kSteepestPath / 2));
  const double keep = flats > 0 ? std::clamp((pitch_mm - room) / flats, 0.0, 1.0) : 0.0;
  const double E = pitch_mm - keep * flats;
  if (E * E + H * H < 2 * H * R) {
    const double shrink = (E * E + H * H) / (2 * H * R);
    radiusFrom *= shrink;
    radiusTo *= shrink;
    R *= shrink;
  }

  // The common tangent of the two arcs: E + i (R - H) = (L + i R) exp(-i angle).
  const double L = std::sqrt(std::max(0.0, E * E + H * H - 2 * H * R));
  const double angle = std::max(0.0, std::atan2(R, L) - std::atan2(R - H, E));
  const double up = climb < 0 ? -1.0 : 1.0;
  end_ = {0.0, from.height_mm, 0.0};
  append(keep * from.flat_mm, 0.0);
  append(radiusFrom * angle, up / radiusFrom);
  append(L, 0.0);
  append(radiusTo * angle, -up / radiusTo);
  append(keep * to.flat_mm, 0.0);
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
