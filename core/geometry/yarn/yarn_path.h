#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/units.h"

namespace loomlight {

/// One point of a yarn's path, at a crossing.
struct PathNode {
  float height_mm = 0;  ///< of the yarn's axis above the mid-plane of the cloth
  float up = 1;         ///< factors of its outline there (SectionOutline)
  float across = 1;
  float aside_mm = 0;  ///< of the axis from the middle of its cell, along u of the cell's frame (cell_strands.h)
  float along_mm = 0;  ///< of the crossing from the middle of its cell, along s
  bool operator==(const PathNode&) const = default;
};

/// Along the cloth from one node to that in the next cell.
inline double spanBetween_mm(const PathNode& from, const PathNode& to, double pitch_mm) {
  return pitch_mm + static_cast<double>(to.along_mm) - static_cast<double>(from.along_mm);
}

/// The steepest a yarn may climb, radians. Setts too tight even for this let yarns interpenetrate.
inline constexpr double kSteepestPath = 75.0 * kPi / 180.0;

/// A point of a yarn's axis: s along the yarn, z up (mm), and the angle of its tangent above the s axis.
struct AxisPoint {
  double s_mm = 0;
  double z_mm = 0;
  double angle = 0;
};

/// What a path can climb from one node to the next, mm, without being steeper anywhere.
double steepestClimb_mm(double span_mm);

/// The path of a yarn's axis from one crossing to the next: horizontal at both nodes, C1 between, single-valued in s:
/// an arc, a straight line and an arc (Peirce), the arcs over a third of the span each. Relaxed yarns bend over 27 %,
/// but wider arcs keep more of a yarn out of the flanks of the one that it bends over.
/// It depends on its two nodes alone, so the two cells that share it agree about it. Its curvature jumps where arcs
/// meet lines, so the tangents of twisted fibres off the axis jump there too, by up to their slope times half-height
/// over radius.
class Transition {
 public:
  /// A piece of constant curvature.
  struct Piece {
    AxisPoint start;
    double begin_mm = 0;  ///< length of axis before it
    double length_mm = 0;
    double curvature_per_mm = 0;  ///< signed: positive turns upwards
  };

  /// From `from` at s = 0 to `to` at s = span, which are no further apart in height than steepestClimb_mm(span).
  Transition(const PathNode& from, const PathNode& to, double span_mm);

  double length_mm() const { return length_mm_; }
  std::span<const Piece> pieces() const { return {pieces_.data(), count_}; }
  /// 0 <= length <= length_mm().
  AxisPoint at(double length_mm) const;
  /// Length of the axis from its start to the plane at s, 0 <= s <= span.
  double lengthTo(double s_mm) const;

 private:
  void append(double length_mm, double curvature_per_mm);

  std::array<Piece, 3> pieces_;
  size_t count_ = 0;
  double length_mm_ = 0;
  AxisPoint end_;
};

}  // namespace loomlight
