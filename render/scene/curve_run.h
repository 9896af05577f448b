#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace loomlight {

/// What a run has of its curve, besides its shape.
struct CurvePart {
  uint32_t curve;     ///< as its maker counts them
  bool begins, ends;  ///< whether the curve does so in this run
};

/// Up to four straight segments of a round curve, one after the other: what lies within the radius of them. In mm. As
/// long as a line of cache, since rays among many of them wait for little else.
class alignas(64) CurveRun {
 public:
  static constexpr int kSegments = 4;

  /// Where a ray comes into segments from outside.
  struct Hits {
    unsigned segments = 0;                    ///< bit by bit: those that it comes into
    std::array<float, kSegments> t;           ///< of the ray; may be negative
    std::array<glm::vec3, kSegments> normal;  ///< outwards, as long as the radius
  };

  /// points: 2 to kSegments + 1.
  CurveRun(std::span<const glm::vec3> points, float radius_mm);

  glm::vec3 point(int i) const {  ///< up to kSegments; beyond the last one the same again
    const auto at = static_cast<size_t>(i);
    return {x_[at], y_[at], z_[at]};
  }
  glm::vec3 tangent(int segment) const { return glm::normalize(point(segment + 1) - point(segment)); }  ///< unit
  float radius_mm() const { return radius_mm_; }

  /// `previous`: the run from which the curve comes, where it does not begin with this one. At a joint the ball is met
  /// only where it lies in no segment; on the inner side of a bend a ray from inside may meet the next segment's wall,
  /// one in thousands. Plain arithmetic of floats, the same on every processor, exact to some roundings of the
  /// coordinates, which should be counted from somewhere near.
  Hits meet(glm::vec3 origin, glm::vec3 direction, const CurvePart& part, const CurveRun* previous) const;

 private:
  using Coordinates = std::array<float, kSegments + 1>;
  bool meetBall(int end, glm::vec3 origin, glm::vec3 direction, float& t, glm::vec3& normal) const;

  Coordinates x_, y_, z_;
  float radius_mm_;
};
static_assert(sizeof(CurveRun) == 64);

}  // namespace loomlight
