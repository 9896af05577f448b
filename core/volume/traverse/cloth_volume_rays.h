#pragma once

// What ClothVolume holds at a place, and rays that come into it, apart from its declaration; included by
// cloth_volume.h.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/simd.h"
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
    if (!components.empty()) content.spans[count++] = {components, reach.system, reach.index, reach.yarn};
  }
  content.count = count;
}

/// A ray, clipped to a piece, its three axes side by side. Rays that are not finite meet nothing.
class ClothVolume::RayInPiece {
 public:
  bool inPiece() const { return inPiece_; }

 protected:
  RayInPiece(const ClothVolume& volume, glm::vec3 origin, glm::vec3 direction, float t0, float t1)
      : volume_(&volume),
        o_{origin.x, origin.y, origin.z - static_cast<double>(volume.grid_.zLower_mm), 0},
        d_{direction.x, direction.y, direction.z, 0},
        t_(std::max(t0, std::numeric_limits<float>::lowest())),
        tEnd_(t1),
        upwards_(direction.x < 0 ? 0 : 1, direction.y < 0 ? 0 : 1, direction.z < 0 ? 0 : 1) {
    if (!(t0 < t1) || !std::isfinite(glm::dot(origin, glm::vec3(1)) + glm::dot(direction, glm::vec3(1)))) return;
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const Float64x4 d = d_, far = broadcast<Float64x4>(kFar);
    const Float64x4 size = numbersOf(volume.cell_mm_ * glm::dvec3(volume.cells_));
    const Int64x4 moves = d != 0, within = (o_ >= 0) & (o_ < size);
    inverse_ = 1 / (moves ? d : broadcast<Float64x4>(1));
    const Float64x4 a = -o_ * inverse_, b = (size - o_) * inverse_;
    const Float64x4 enter = moves ? least(a, b) : (within ? -far : far), leave = moves ? most(a, b) : far;
    t_ = std::max({t_, enter[0], enter[1], enter[2]});
    tEnd_ = std::min({tEnd_, leave[0], leave[1], leave[2]});
    inPiece_ = t_ < tEnd_;
  }

  static Float64x4 numbersOf(glm::dvec3 v) { return Float64x4{v.x, v.y, v.z, 1}; }
  /// Lengths in units of which there are so many: from 0 to the last.
  static Int32x4 numbersWithin(Float64x4 length, glm::dvec3 perLength, glm::ivec3 count) {
    return truncated(most(Float64x4{}, least(length * numbersOf(perLength), numbersOf(glm::dvec3(count - 1)))));
  }
  /// The cell that it is in at t.
  Int32x4 cellAtStart() const { return numbersWithin(o_ + t_ * d_, volume_->perCell_, volume_->cells_); }
  const ClothVolume* volume_;
  // In double: at the far side of a wide cloth a float's step is no longer small beside a voxel.
  Float64x4 o_, d_, inverse_{};  ///< 1 / d, and 1 where it does not move; the fourth number counts for nothing
  double t_, tEnd_;              ///< how far it has come, and goes
  glm::ivec3 upwards_;           ///< 0 where it moves to lesser coordinates, else 1; numbers: no branch predicts signs
  bool inPiece_ = false;
};

}  // namespace loomlight
