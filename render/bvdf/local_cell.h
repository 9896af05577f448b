#pragma once

#include <algorithm>
#include <limits>

#include "core/volume/traverse/cloth_volume.h"

namespace loomlight {

/// The cell around an event within which the BVDF knows what shadows what: the voxel of the octree's first level above
/// the leaves, twice as wide as a leaf (section 8.2 of the report). Cloth coordinates, half-open.
struct LocalCell {
  glm::dvec3 lower, upper;

  /// The cell of a point; points outside the volume's slab have the nearest layer's.
  static LocalCell around(glm::vec3 cloth, const ClothVolume& volume) {
    const VoxelGrid& grid = volume.grid();
    const ClothGeometry& geometry = volume.geometry();
    const glm::dvec3 leaf(geometry.warpPitch_mm() / grid.cell.x, geometry.weftPitch_mm() / grid.cell.y, grid.size_mm.z);
    const glm::dvec3 corner(0, 0, grid.zLower_mm);
    LocalCell cell;
    for (int axis = 0; axis < 3; ++axis) {
      const int perCrossing = grid.cell[axis];
      const double leaves = (cloth[axis] - corner[axis]) / leaf[axis];
      const double crossing = axis == 2 ? 0.0 : std::floor(leaves / perCrossing);
      const int inCrossing = std::clamp(static_cast<int>(leaves - crossing * perCrossing), 0, perCrossing - 1) & ~1;
      const double first = crossing * perCrossing + inCrossing;
      // The last cell of a crossing is cut by its edge.
      const double count = std::min(2, perCrossing - inCrossing);
      cell.lower[axis] = corner[axis] + first * leaf[axis];
      cell.upper[axis] = corner[axis] + (first + count) * leaf[axis];
    }
    return cell;
  }

  /// Parameter at which a ray leaves the cell; 0 where it starts beyond it.
  float exit(glm::vec3 origin, glm::vec3 direction) const {
    double t = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0) continue;
      const double face = direction[axis] > 0 ? upper[axis] : lower[axis];
      t = std::min(t, (face - origin[axis]) / direction[axis]);
    }
    return static_cast<float>(std::max(0.0, t));
  }
};

}  // namespace loomlight
