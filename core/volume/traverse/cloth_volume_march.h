#pragma once

// The traversal of ClothVolume, apart from its declaration; included by cloth_volume.h.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/volume/traverse/cloth_volume.h"

namespace loomlight {

inline void ClothVolume::gather(System system, int across, int along, Reaches& reaches) const {
  const TileMap& tiles = tiles_[static_cast<int>(system)];
  const int axis = system == System::warp ? 0 : 1;
  const auto add = [&](const BrickPool::Entry& brick, int neighbour) {
    Reach& reach = reaches.entries[reaches.count++];
    reach.brick = &brick;
    reach.shift = -brick.box.lower;
    reach.shift[axis] -= neighbour * blocksPerCell_[axis];
    reach.system = system;
    reach.index = across + neighbour;
    reach.yarn = geometry_->yarnIndex(system, reach.index);
  };
  add(tiles.at(across, along), 0);
  if (tiles.anyReachesAbove() && across > 0) {
    const BrickPool::Entry& brick = tiles.at(across - 1, along);
    if (brick.reachesAbove) add(brick, -1);
  }
  if (tiles.anyReachesBelow() && across + 1 < cells_[axis]) {
    const BrickPool::Entry& brick = tiles.at(across + 1, along);
    if (brick.reachesBelow) add(brick, 1);
  }
}

inline void ClothVolume::gather(int pick, int end, Reaches& reaches) const {
  reaches.count = 0;
  gather(System::warp, end, pick, reaches);
  gather(System::weft, pick, end, reaches);
}

inline uint64_t ClothVolume::openBlock(Reaches& reaches, glm::ivec3 block) const {
  uint64_t occupied = 0;
  for (int i = 0; i < reaches.count; ++i) {
    Reach& reach = reaches.entries[i];
    const int number = reach.brick->box.number(block + reach.shift);
    reach.block = number >= 0 ? blocks_ + reach.brick->firstBlock + number : nullptr;
    if (reach.block) occupied |= reach.block->occupied;
  }
  return occupied;
}

inline void ClothVolume::look(const Reaches& reaches, int voxel, VoxelContent& content) const {
  int count = 0;
  for (int i = 0; i < reaches.count; ++i) {
    const Reach& reach = reaches.entries[i];
    if (!reach.block) continue;
    const std::span<const Component> components = reach.block->at(voxel, components_);
    if (!components.empty()) content.parts[count++] = {components, reach.system, reach.index, reach.yarn};
  }
  content.count = count;
}

/// A ray on its way through a piece, block by block of 4 x 4 x 4 voxels.
class ClothVolume::Walk {
 public:
  Walk(const ClothVolume& volume, glm::vec3 origin, glm::vec3 direction)
      : volume_(volume), level_(volume.grid_.level), perCell_(volume.grid_.perCell()), o_(origin), d_(direction) {
    o_.z -= volume.grid_.zLower_mm;
    for (int axis = 0; axis < 3; ++axis) {
      upwards_[axis] = d_[axis] > 0 ? 1 : 0;
      inverse_[axis] = d_[axis] != 0 ? 1 / d_[axis] : 0;
      never_[axis] = d_[axis] != 0 ? 0 : std::numeric_limits<double>::infinity();
    }
  }

  /// Clips [t, tEnd] to the piece; false if nothing is left.
  bool clip(double& t, double& tEnd) {
    const glm::dvec3 size = volume_.cell_mm_ * glm::dvec3(volume_.cells_);
    for (int axis = 0; axis < 3; ++axis) {
      if (d_[axis] == 0) {
        if (!(o_[axis] >= 0 && o_[axis] < size[axis])) return false;
        continue;
      }
      const double a = -o_[axis] * inverse_[axis], b = (size[axis] - o_[axis]) * inverse_[axis];
      t = std::max(t, std::min(a, b));
      tEnd = std::min(tEnd, std::max(a, b));
    }
    return t < tEnd;
  }

  /// Goes to the block at t.
  void start(double t) {
    for (int axis = 0; axis < 3; ++axis) {
      const double position = o_[axis] + t * d_[axis];
      cell[axis] = std::clamp(static_cast<int>(position * volume_.perCell_[axis]), 0, volume_.cells_[axis] - 1);
      enterCell(axis);
      block[axis] = voxelAt(axis, t) >> 2;
      tBlock[axis] = faceAhead(axis, lastVoxel(axis));
    }
  }

  /// Crosses the block's face in an axis; false if this leaves the piece.
  bool leaveBlock(int axis) {
    const int step = 2 * upwards_[axis] - 1, count = (perCell_[axis] + 3) >> 2;
    block[axis] += step;
    cellChanged = static_cast<unsigned>(block[axis]) >= static_cast<unsigned>(count);
    if (cellChanged) {
      cell[axis] += step;
      if (static_cast<unsigned>(cell[axis]) >= static_cast<unsigned>(volume_.cells_[axis])) return false;
      block[axis] = upwards_[axis] ? 0 : count - 1;
      enterCell(axis);
    }
    tBlock[axis] = faceAhead(axis, lastVoxel(axis));
    voxel[axis] = firstVoxel(axis);
    tVoxel[axis] = faceAhead(axis, voxel[axis]);
    return true;
  }

  /// Goes to the voxel of the block at t: in the block, whatever rounding says.
  void findVoxel(double t) {
    for (int axis = 0; axis < 3; ++axis) {
      voxel[axis] = std::clamp(voxelAt(axis, t), 4 * block[axis], std::min(4 * block[axis] + 3, perCell_[axis] - 1));
      tVoxel[axis] = faceAhead(axis, voxel[axis]);
    }
  }
  void leaveVoxel(int axis) {
    voxel[axis] += 2 * upwards_[axis] - 1;
    tVoxel[axis] = faceAhead(axis, voxel[axis]);
  }
  glm::ivec3 voxelOfCloth() const { return cell * perCell_ + voxel; }

  static int nearest(const glm::dvec3& t) {
    const int axis = t.y < t.x ? 1 : 0;
    return t.z < t[axis] ? 2 : axis;
  }

  glm::ivec3 cell{0}, block{0}, voxel{0};  ///< block and voxel: in their cell
  glm::dvec3 tBlock{0}, tVoxel{0};         ///< where the ray crosses their faces ahead
  bool cellChanged = false;

 private:
  void enterCell(int axis) { inCell_[axis] = o_[axis] - cell[axis] * volume_.cell_mm_[axis]; }

  int voxelAt(int axis, double t) const {
    const double leaf = (inCell_[axis] + t * d_[axis]) * volume_.perVoxel_[axis];
    return std::clamp(static_cast<int>(leaf), 0, volume_.grid_.cell[axis] - 1) >> level_;
  }
  /// Of the block, those that the ray enters and leaves it by.
  int firstVoxel(int axis) const { return std::min(4 * block[axis] + 3 * (1 - upwards_[axis]), perCell_[axis] - 1); }
  int lastVoxel(int axis) const { return std::min(4 * block[axis] + 3 * upwards_[axis], perCell_[axis] - 1); }
  double faceAhead(int axis, int v) const {
    const int leaf = std::min((v + upwards_[axis]) << level_, volume_.grid_.cell[axis]);
    return (leaf * volume_.voxel_mm_[axis] - inCell_[axis]) * inverse_[axis] + never_[axis];
  }

  const ClothVolume& volume_;
  int level_;
  glm::ivec3 perCell_;
  // In double: at the far side of a wide cloth a float's step is no longer small beside a voxel.
  glm::dvec3 o_, d_, inverse_{0}, inCell_{0};
  glm::dvec3 never_{0};  ///< infinite in the axes that the ray does not move along
  glm::ivec3 upwards_{
      0};  ///< 1 where it moves to greater coordinates; numbers, because signs are what no branch predicts
};

template <class Visit>
bool ClothVolume::march(glm::vec3 origin, glm::vec3 direction, float t0, float t1, Visit&& visit) const {
  if (!(t0 < t1) || !std::isfinite(glm::dot(origin, glm::vec3(1)) + glm::dot(direction, glm::vec3(1)))) return true;
  double t = std::max(t0, std::numeric_limits<float>::lowest()), tEnd = t1;
  Walk walk(*this, origin, direction);
  if (!walk.clip(t, tEnd)) return true;
  walk.start(t);
  walk.cellChanged = true;

  VoxelContent content;
  Reaches reaches;
  bool inStep = false;  // whether the walk's voxel is that at t, without looking for it
  for (;;) {
    if (walk.cellChanged) {
      content.end = walk.cell.x;
      content.pick = walk.cell.y;
      gather(content.pick, content.end, reaches);
    }
    const uint64_t occupied = openBlock(reaches, walk.block);
    const int side = Walk::nearest(walk.tBlock);
    const double tLeaveBlock = std::min(walk.tBlock[side], tEnd);
    if (occupied != 0 && tLeaveBlock > t) {
      if (!inStep) walk.findVoxel(t);
      // The faces of a block are faces of its voxels, computed alike, so the walk cannot step out of the block.
      for (;;) {
        const int axis = Walk::nearest(walk.tVoxel), number = numberInBlock(walk.voxel);
        const double tLeave = std::min(walk.tVoxel[axis], tLeaveBlock);
        // A step of no length is that of a ray through an edge, or one that starts on a face.
        const auto enter = static_cast<float>(t), leave = static_cast<float>(tLeave);
        if ((occupied >> number & 1) != 0 && enter < leave) {
          look(reaches, number, content);
          content.voxel = walk.voxelOfCloth();
          if (!visit(static_cast<const VoxelContent&>(content), enter, leave)) return false;
        }
        t = std::max(t, tLeave);
        if (!(walk.tVoxel[axis] < tLeaveBlock)) break;
        walk.leaveVoxel(axis);
      }
      inStep = true;
    } else {
      inStep = false;
    }
    t = std::max(t, tLeaveBlock);
    if (!(walk.tBlock[side] < tEnd) || !walk.leaveBlock(side)) return true;
  }
}

}  // namespace loomlight
