#pragma once

#include <algorithm>

#include "core/geometry/cloth/cloth_geometry.h"

namespace loomlight {

/// The voxel grid all bricks of a cloth share. Leaves need not be exact cubes: a cell holds a whole number of them. A
/// voxel is 2^level leaves wide, counted from the cell's corner, so the last one of a cell may be cut by its edge.
struct VoxelGrid {
  glm::ivec3 cell{1};       ///< leaves of one cell in x (across ends), y (across picks), z
  glm::vec3 size_mm{1.0f};  ///< of a leaf
  float zLower_mm = 0;      ///< bottom of voxel layer 0
  int level = 0;            ///< 0: voxels are leaves
  bool operator==(const VoxelGrid&) const = default;

  VoxelGrid atLevel(int other) const { return {cell, size_mm, zLower_mm, other}; }
  /// So many levels there are, the last with one voxel in a cell.
  int levels() const;
  /// Voxels of one cell.
  glm::ivec3 perCell() const { return (cell + ((1 << level) - 1)) >> level; }
  /// Corner of a leaf of the whole cloth.
  glm::vec3 lower_mm(glm::ivec3 leaf) const { return glm::vec3(leaf) * size_mm + glm::vec3(0, 0, zLower_mm); }
  /// Extent in an axis of the voxels with this coordinate, 0 <= i < perCell()[axis].
  double extent_mm(int axis, int i) const {
    return (std::min((i + 1) << level, cell[axis]) - (i << level)) * static_cast<double>(size_mm[axis]);
  }
  /// Volume of a voxel, as its brick counts it: below 0 and beyond the cell's size the next cells follow.
  double volume_mm3(glm::ivec3 voxel) const;
};

/// `resolution` leaf voxels per (smallest) yarn diameter; the slab |z| <= halfThickness is covered. Beyond 8, the leaf
/// is no narrower than the (thinnest) fibres. Of absurd cloths, fine yarns in wide gaps or beside ropes,
/// it is coarser, so that no cell has more than kMaxCellVoxels.
VoxelGrid makeGrid(const ClothGeometry& geometry, int resolution);
inline constexpr double kMaxCellVoxels = 2e6;

}  // namespace loomlight
