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

/// Follows the ray from + t direction (unit) through every fold of the shell that it meets, for t in (0, tMax), and
/// calls visit(const ShellSegment&), in order, until it returns false. True if nothing stopped it.
template <class Visit>
bool walkShell(const TraceData& cloth, const ScenePoint& from, glm::vec3 direction, float tMax, Visit&& visit) {
  const Shell& shell = *cloth.shell;
  const bool flat = shell.isFlat();
  int tet = from.tet;
  glm::vec3 origin = from.world;
  float passed = 0;  // a far eye must not cost precision inside the cloth, so its ray begins anew near the cloth
  if (tet < 0) {
    const float distance = distanceToBounds(shell, origin, direction);
    if (!(distance < tMax)) return true;
    passed = 0.999f * distance;
    origin += passed * direction;
    tMax -= passed;
  }
  for (float t = 0;;) {
    if (tet < 0) {
      const auto hit = cloth.entry->enter(origin, direction, t, tMax);
      if (!hit) return true;
      tet = hit->tet;
      t = hit->t;
    }
    while (tet >= 0) {
      int face = 0;
      const float tExit = std::max(t, shell.exit(tet, origin, direction, face));
      ShellSegment segment{tet, origin, t, std::min(tExit, tMax), passed, shell.toCloth(tet, origin), direction, {}};
      if (!flat) {
        segment.drape.frame = shell.frame(tet, origin + 0.5f * (t + segment.tLeave) * direction);
        segment.drape.densityScale = 1.0f / std::abs(glm::determinant(segment.drape.frame));
        segment.drape.isometric = false;
        segment.clothDirection = shell.tets()[tet].toCloth * direction;
      }
      if (!visit(static_cast<const ShellSegment&>(segment))) return false;
      if (tExit >= tMax || flat) return true;  // flat: a box is convex, what leaves it is gone
      t = tExit;
      tet = shell.tets()[tet].neighbour[face];
    }
  }
}

/// Shows each voxel with content on the way, in order, to visit(const VoxelContent&, float tEnter, float tLeave, const
/// LocalDrape&, int tet), which returns false to stop. Parameters are world distances from `from`.
template <class Visit>
bool walkCloth(const TraceData& cloth, const ScenePoint& from, glm::vec3 direction, float tMax, Visit&& visit) {
  return walkShell(cloth, from, direction, tMax, [&](const ShellSegment& s) {
    return cloth.volume->march(s.clothOrigin, s.clothDirection, s.tEnter, s.tLeave,
                               [&](const VoxelContent& content, float tEnter, float tLeave) {
                                 return visit(content, s.passed + tEnter, s.passed + tLeave, s.drape, s.tet);
                               });
  });
}

}  // namespace loomlight
