#pragma once

// Point look-ups in a ClothVolume, apart from its declaration; included by cloth_volume.h.

#include <algorithm>

#include "core/volume/traverse/cloth_volume.h"

namespace loomlight {

/// Looks up one point after another, each near the last, as a ray that is displaced at every step does: the bricks of a
/// cell are gathered only when the cell changes. In float: half a voxel is far beyond its rounding on any piece that
/// one sees whole, and a point has no neighbour that it must join.
class ClothVolume::Probe {
 public:
  explicit Probe(const ClothVolume& volume)
      : volume_(volume), cell_mm_(volume.cell_mm_), perCell_(volume.perCell_), perVoxel_(volume.perVoxel_) {}

  /// What the voxel around a point holds. Returns a distance, mm, within which no other point has content either: 0
  /// unless the point's whole block is empty.
  float look(glm::vec3 cloth_mm, VoxelContent& content) {
    content.count = 0;
    const glm::vec3 p(cloth_mm.x, cloth_mm.y, cloth_mm.z - volume_.grid_.zLower_mm);
    const glm::vec3 scaled = p * perCell_;
    const glm::ivec3 cell(glm::floor(scaled));
    if (static_cast<unsigned>(cell.x) >= static_cast<unsigned>(volume_.cells_.x) ||
        static_cast<unsigned>(cell.y) >= static_cast<unsigned>(volume_.cells_.y) || cell.z != 0)
      return 0;
    if (cell != cell_) {
      cell_ = cell;
      volume_.gather(cell.y, cell.x, reaches_);
    }
    const glm::vec3 inVoxels = (p - glm::vec3(cell) * cell_mm_) * perVoxel_;
    const glm::ivec3 voxel = glm::clamp(glm::ivec3(inVoxels), glm::ivec3(0), volume_.grid_.cell - 1);
    const uint64_t occupied = volume_.openBlock(reaches_, voxel >> 2);
    if (occupied == 0) {
      // The last block of a cell may be cut by the cell's edge.
      const glm::ivec3 first = (voxel >> 2) * 4;
      const glm::vec3 lower = inVoxels - glm::vec3(first);
      const glm::vec3 upper = glm::vec3(glm::min(first + 4, volume_.grid_.cell)) - inVoxels;
      const glm::vec3 nearest = glm::min(lower, upper) * volume_.grid_.size_mm;
      return std::max(0.0f, std::min({nearest.x, nearest.y, nearest.z}));
    }
    const int number = numberInBlock(voxel);
    if (occupied >> number & 1) {
      volume_.look(reaches_, number, content);
      content.end = cell.x;
      content.pick = cell.y;
      content.voxel = cell * volume_.grid_.cell + voxel;
    }
    return 0;
  }

 private:
  const ClothVolume& volume_;
  glm::vec3 cell_mm_, perCell_, perVoxel_;
  glm::ivec3 cell_{-1};
  Reaches reaches_;
};

}  // namespace loomlight
