#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/media/medium.h"
#include "render/scene/shell_entry.h"

namespace loomlight {

/// How the cloth lies where a ray crosses it: cloth-space tangents and densities become those of the world.
struct LocalDrape {
  glm::mat3 frame{1.0f};      ///< d world / d cloth
  float densityScale = 1.0f;  ///< 1 / det frame: the same fibres in more or less room
  bool isometric = true;      ///< flat: nothing to transform

  /// At a place of the world that is in this tetrahedron of the shell.
  static LocalDrape at(const Shell& shell, int tet, glm::vec3 world) {
    if (shell.isFlat()) return {};
    const glm::mat3 frame = shell.frame(tet, world);
    return {frame, 1.0f / std::abs(glm::determinant(frame)), false};
  }
  /// World tangent of unit length; `stretch` receives the factor on the fibre's length.
  glm::vec3 tangent(glm::vec3 cloth, float& stretch) const {
    const glm::vec3 bent = frame * cloth;
    stretch = glm::length(bent);
    return bent / stretch;
  }
  /// Unit normal of the cloth's face.
  glm::vec3 normal() const { return isometric ? glm::vec3(0, 0, 1) : glm::normalize(glm::cross(frame[0], frame[1])); }
};

/// Distance at which a ray comes to the shell's bounds, 0 from inside of them; infinite if it misses them.
inline float distanceToBounds(const Shell& shell, glm::vec3 origin, glm::vec3 direction) {
  float enter = 0, leave = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const float inverse = 1.0f / direction[axis];
    const float a = (shell.lower_mm()[axis] - origin[axis]) * inverse;
    const float b = (shell.upper_mm()[axis] - origin[axis]) * inverse;
    enter = std::max(enter, std::min(a, b));  // a NaN (in the plane of a face) loses every comparison
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave * (1 + 1e-5f) + 1e-5f ? enter : std::numeric_limits<float>::infinity();
}

/// The part of a ray that lies in one tetrahedron of the shell (or in the box of a flat one).
struct ShellSegment {
  int tet;
  glm::vec3 origin;          ///< of the ray, world
  float tEnter, tLeave;      ///< on the ray, from that origin
  float passed;              ///< distance from where the walk began to that origin
  glm::vec3 clothOrigin;     ///< the same ray in cloth space, with the same parameter
  glm::vec3 clothDirection;  ///< of any length
  LocalDrape drape;
};

/// A ray on its way through every fold of the shell that it meets: it stops at each part of it that lies in one
/// tetrahedron, in order, and goes on when it is asked to.
class ShellWalk {
 public:
  /// The ray from + t direction (unit) for t in (0, tMax). The cloth must outlive the walk.
  ShellWalk(const TraceData& cloth, const ScenePoint& from, glm::vec3 direction, float tMax)
      : shell_(*cloth.shell),
        entry_(*cloth.entry),
        origin_(from.world),
        direction_(direction),
        tMax_(tMax),
        tet_(from.tet) {
    if (tet_ >= 0) return;
    // A far eye must not cost precision inside the cloth, so its ray begins anew near the cloth.
    const float distance = distanceToBounds(shell_, origin_, direction);
    over_ = !(distance < tMax);
    if (over_) return;
    passed_ = 0.999f * distance;
    origin_ += passed_ * direction;
    tMax_ -= passed_;
  }

  /// False where nothing is left.
  bool next() {
    if (over_) return false;
    if (tet_ < 0) {
      const auto hit = entry_.enter(origin_, direction_, t_, tMax_);
      over_ = !hit;
      if (over_) return false;
      tet_ = hit->tet;
      t_ = hit->t;
    }
    int face = 0;
    const float tExit = std::max(t_, shell_.exit(tet_, origin_, direction_, face));
    const bool flat = shell_.isFlat();
    segment_.tet = tet_;
    segment_.origin = origin_;
    segment_.tEnter = t_;
    segment_.tLeave = std::min(tExit, tMax_);
    segment_.passed = passed_;
    segment_.clothOrigin = shell_.toCloth(tet_, origin_);
    segment_.clothDirection = flat ? direction_ : shell_.tets()[tet_].toCloth * direction_;
    segment_.drape = LocalDrape::at(shell_, tet_, origin_ + 0.5f * (t_ + segment_.tLeave) * direction_);
    over_ = tExit >= tMax_ || flat;  // flat: a box is convex, what leaves it is gone
    if (!over_) {
      t_ = tExit;
      tet_ = shell_.tets()[tet_].neighbour[face];
    }
    return true;
  }

  /// Where it stands, until it goes on.
  const ShellSegment& segment() const { return segment_; }

 private:
  const Shell& shell_;
  const ShellEntry& entry_;
  glm::vec3 origin_, direction_;
  float tMax_, t_ = 0;  ///< from the origin
  float passed_ = 0;    ///< from where the walk began to the origin
  int tet_;
  bool over_ = false;
  ShellSegment segment_{};
};

}  // namespace loomlight
