#pragma once

// The traversal of ClothVolume, apart from its declaration; included by cloth_volume.h.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/volume/cloth_volume.h"

namespace loomlight {

inline void ClothVolume::gather(System system, int across, int along, int level, Reaches& reaches) const {
  const TileMap& tiles = tiles_[static_cast<int>(system)];
  const int axis = system == System::warp ? 0 : 1;
  const int inRepeat = along % tiles.repeatAlong();
  const auto add = [&](const TileMap::Slot& slot, int neighbour) {
    Reach& reach = reaches.entries[reaches.count++];
    reach.level = &slot.brick->level(level);
    reach.shift = -reach.level->lower;
    reach.shift[axis] -= neighbour * reach.level->blocksPerCell()[axis];
    reach.system = system;
    reach.index = across + neighbour;
  };
  add(tiles.at(across, along, inRepeat), 0);
  if (tiles.anyReachesAbove() && across > 0) {
    const TileMap::Slot& slot = tiles.at(across - 1, along, inRepeat);
    if (slot.reachesAbove) add(slot, -1);
  }
  if (tiles.anyReachesBelow() && across + 1 < cells_[axis]) {
    const TileMap::Slot& slot = tiles.at(across + 1, along, inRepeat);
    if (slot.reachesBelow) add(slot, 1);
  }
}

inline void ClothVolume::gather(int pick, int end, int level, Reaches& reaches) const {
  reaches.count = 0;
  gather(System::warp, end, pick, level, reaches);
  gather(System::weft, pick, end, level, reaches);
}

inline uint64_t ClothVolume::openBlock(Reaches& reaches, glm::ivec3 block) {
  uint64_t occupied = 0;
  for (int i = 0; i < reaches.count; ++i) {
    Reach& reach = reaches.entries[i];
    reach.block = reach.level->blockFromLower(block + reach.shift);
    if (reach.block) occupied |= reach.block->occupied;
  }
  return occupied;
}

inline void ClothVolume::look(const Reaches& reaches, int voxel, VoxelContent& content) {
  int count = 0;
  for (int i = 0; i < reaches.count; ++i) {
    const Reach& reach = reaches.entries[i];
    if (!reach.block) continue;
    const std::span<const Component> components = reach.level->at(*reach.block, voxel);
    if (!components.empty()) content.parts[count++] = {components, reach.system, reach.index};
  }
  content.count = count;
}

/// A ray on its way through the voxels of a piece; march() is its loop.
class ClothVolume::Walk {
 public:
  Walk(const ClothVolume& volume, glm::vec3 origin, glm::vec3 direction, int level)
      : volume_(volume), level_(level), perCell_(volume.grid_.cellAt(level)), o_(origin), d_(direction) {
    o_.z -= volume.grid_.zLower_mm;
  }

  /// Clips [t, tEnd] to the piece; false if nothing is left.
  bool clip(double& t, double& tEnd) {
    const glm::dvec3 size = volume_.cell_mm_ * glm::dvec3(volume_.cells_);
    for (int axis = 0; axis < 3; ++axis) {
      if (d_[axis] == 0) {
        if (!(o_[axis] >= 0 && o_[axis] < size[axis])) return false;
        continue;
      }
      inverse_[axis] = 1 / d_[axis];
      const double a = -o_[axis] * inverse_[axis], b = (size[axis] - o_[axis]) * inverse_[axis];
      t = std::max(t, std::min(a, b));
      tEnd = std::min(tEnd, std::max(a, b));
    }
    return t < tEnd;
  }

  /// Goes to the voxel at t.
  void start(double t) {
    for (int axis = 0; axis < 3; ++axis) {
      const double position = o_[axis] + t * d_[axis];
      cell[axis] = std::clamp(static_cast<int>(position / volume_.cell_mm_[axis]), 0, volume_.cells_[axis] - 1);
      enterCell(axis);
      voxel[axis] = voxelAt(axis, t);
      tNext[axis] = faceAhead(axis, voxel[axis]);
    }
  }

  /// Crosses the face ahead in an axis; false if this leaves the piece.
  bool step(int axis) { return moveTo(axis, voxel[axis] + (d_[axis] > 0 ? 1 : -1)); }

  /// Leaves the block of 4 x 4 x 4 voxels; t becomes where. False if this leaves the piece or passes tEnd.
  bool leaveBlock(double& t, double tEnd, int& axis) {
    glm::ivec3 last;
    glm::dvec3 exit;
    for (int i = 0; i < 3; ++i) {
      last[i] = d_[i] > 0 ? std::min(voxel[i] | 3, perCell_[i] - 1) : voxel[i] & ~3;
      exit[i] = faceAhead(i, last[i]);
    }
    axis = nearest(exit);
    if (!(exit[axis] < tEnd)) return false;
    t = std::max(t, exit[axis]);
    for (int i = 0; i < 3; ++i) {
      if (i == axis) continue;
      // Never back, nor out of the block, whatever rounding says.
      const int reached = voxelAt(i, t);
      voxel[i] = d_[i] > 0 ? std::clamp(reached, voxel[i], last[i]) : std::clamp(reached, last[i], voxel[i]);
      tNext[i] = faceAhead(i, voxel[i]);
    }
    return moveTo(axis, last[axis] + (d_[axis] > 0 ? 1 : -1));
  }

  static int nearest(glm::dvec3 t) {
    const int axis = t.y < t.x ? 1 : 0;
    return t.z < t[axis] ? 2 : axis;
  }

  glm::ivec3 cell{0}, voxel{0};  ///< voxel: of the level, in its cell
  glm::dvec3 tNext{0};           ///< of the faces ahead

 private:
  void enterCell(int axis) { inCell_[axis] = o_[axis] - cell[axis] * volume_.cell_mm_[axis]; }

  int voxelAt(int axis, double t) const {
    const double leaf = (inCell_[axis] + t * d_[axis]) * volume_.perVoxel_[axis];
    return std::clamp(static_cast<int>(leaf), 0, volume_.grid_.cell[axis] - 1) >> level_;
  }

  double faceAhead(int axis, int v) const {
    if (d_[axis] == 0) return std::numeric_limits<double>::infinity();
    const int leaf = d_[axis] > 0 ? std::min((v + 1) << level_, volume_.grid_.cell[axis]) : v << level_;
    return (leaf * volume_.voxel_mm_[axis] - inCell_[axis]) * inverse_[axis];
  }

  bool moveTo(int axis, int v) {
    cellChanged = static_cast<unsigned>(v) >= static_cast<unsigned>(perCell_[axis]);
    if (cellChanged) {
      const bool up = v > 0;
      cell[axis] += up ? 1 : -1;
      if (static_cast<unsigned>(cell[axis]) >= static_cast<unsigned>(volume_.cells_[axis])) return false;
      v = up ? 0 : perCell_[axis] - 1;
      enterCell(axis);
    }
    voxel[axis] = v;
    tNext[axis] = faceAhead(axis, v);
    return true;
  }

  const ClothVolume& volume_;
  int level_;
  glm::ivec3 perCell_;
  // In double: at the far side of a wide cloth a float's step is no longer small beside a voxel.
  glm::dvec3 o_, d_, inverse_{0}, inCell_{0};

 public:
  bool cellChanged = false;
};

template <class Visit>
bool ClothVolume::march(glm::vec3 origin, glm::vec3 direction, float t0, float t1, Visit&& visit, int level) const {
  if (!(t0 < t1) || !std::isfinite(glm::dot(origin, glm::vec3(1)) + glm::dot(direction, glm::vec3(1)))) return true;
  double t = std::max(t0, std::numeric_limits<float>::lowest()), tEnd = t1;
  Walk walk(*this, origin, direction, level);
  if (!walk.clip(t, tEnd)) return true;
  walk.start(t);

  const glm::ivec3 perCell = grid_.cellAt(level);
  VoxelContent content;
  Reaches reaches;
  const auto enterCell = [&] {
    content.end = walk.cell.x;
    content.pick = walk.cell.y;
    gather(walk.cell.y, walk.cell.x, level, reaches);
  };
  enterCell();
  uint64_t occupied = openBlock(reaches, walk.voxel >> 2);
  for (;;) {
    int axis = 0, before = 0;
    if (occupied == 0) {
      if (!walk.leaveBlock(t, tEnd, axis)) return true;
      before = -1;
    } else {
      axis = Walk::nearest(walk.tNext);
      const double tLeave = std::min(walk.tNext[axis], tEnd);
      const int number = numberInBlock(walk.voxel);
      // A step of no length is that of a ray through an edge, or one that starts on a face.
      if (occupied >> number & 1 && tLeave > t) {
        const auto enter = static_cast<float>(t), leave = static_cast<float>(tLeave);
        if (enter < leave) {
          look(reaches, number, content);
          content.voxel = walk.cell * perCell + walk.voxel;
          if (!visit(static_cast<const VoxelContent&>(content), enter, leave)) return false;
        }
      }
      if (!(walk.tNext[axis] < tEnd)) return true;
      t = std::max(t, tLeave);
      before = walk.voxel[axis] >> 2;
      if (!walk.step(axis)) return true;
    }
    if (walk.cellChanged) enterCell();
    if (walk.cellChanged || walk.voxel[axis] >> 2 != before) occupied = openBlock(reaches, walk.voxel >> 2);
  }
}

}  // namespace loomlight
