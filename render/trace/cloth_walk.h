#pragma once

#include <limits>

#include "render/trace/scene.h"
#include "render/trace/shell_entry.h"

namespace loomlight {

/// A point of the scene, and the shell's tetrahedron it lies in; -1 outside of the shell.
struct Place {
  glm::vec3 world{0};
  int tet = -1;
};

/// How the cloth lies where a ray crosses it: cloth-space tangents and densities become those of the world.
struct LocalDrape {
  glm::mat3 frame{1.0f};       ///< d world / d cloth
  float densityScale = 1.0f;   ///< 1 / det frame: the same fibres in more or less room
  bool isometric = true;       ///< flat: nothing to transform

  /// World tangent of unit length; `stretch` receives the factor on the fibre's length.
  glm::vec3 tangent(glm::vec3 cloth, float& stretch) const {
    const glm::vec3 bent = frame * cloth;
    stretch = glm::length(bent);
    return bent / stretch;
  }
  /// Unit normal of the cloth's face.
  glm::vec3 normal() const { return isometric ? glm::vec3(0, 0, 1) : glm::normalize(glm::cross(frame[0], frame[1])); }
};

/// Follows the ray from + t direction (unit) through every fold of the shell that it meets, for t in (0, tMax), and
/// shows each voxel with content, in order, to visit(const VoxelContent&, float tEnter, float tLeave, const LocalDrape&,
/// int tet), which returns false to stop. Parameters are world distances. True if nothing stopped it.
template <class Visit>
bool walkCloth(const Scene& scene, const Place& from, glm::vec3 direction, float tMax, Visit&& visit) {
  const Shell& shell = *scene.shell;
  const ClothVolume& volume = *scene.volume;
  const bool flat = shell.isFlat();
  int tet = from.tet;
  float passed = 0;               // distance from `from` to `origin`
  glm::vec3 origin = from.world;  // moved to each entry, so that far cameras cost no precision inside the cloth
  for (;;) {
    if (tet < 0) {
      const auto hit = scene.entry->enter(origin, direction, 0.0f, tMax - passed);
      if (!hit) return true;
      tet = hit->tet;
      passed += hit->t;
      origin += hit->t * direction;
    }
    for (float t = 0; tet >= 0;) {
      int face = 0;
      const float tExit = std::max(t, shell.exit(tet, origin, direction, face));
      const float tStop = std::min(tExit, tMax - passed);
      LocalDrape drape;
      glm::vec3 clothDirection = direction;
      if (!flat) {
        const glm::vec3 middle = origin + 0.5f * (t + tStop) * direction;
        drape.frame = shell.frame(tet, middle);
        drape.densityScale = 1.0f / std::abs(glm::determinant(drape.frame));
        drape.isometric = false;
        clothDirection = shell.tets()[tet].toCloth * direction;
      }
      const bool through =
          volume.march(shell.toCloth(tet, origin), clothDirection, t, tStop,
                       [&](const VoxelContent& content, float tEnter, float tLeave) {
                         return visit(content, passed + tEnter, passed + tLeave, drape, tet);
                       });
      if (!through) return false;
      if (tStop < tExit) return true;
      t = tExit;
      tet = flat ? -1 : shell.tets()[tet].neighbour[face];
      if (tet < 0) {
        passed += t;
        origin += t * direction;
      }
    }
    if (flat) return true;  // a box is convex: what leaves it is gone
  }
}

}  // namespace loomlight
