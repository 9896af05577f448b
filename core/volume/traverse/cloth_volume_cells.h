#pragma once

// How rays come into the cells of ClothVolume, apart from its declaration; included by cloth_volume.h.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/simd.h"
#include "core/volume/traverse/cloth_volume_march.h"

namespace loomlight {

/// Those of `bricks` that count.
struct ClothVolume::CellBricks {
  struct Brick {
    glm::ivec3 shift;  ///< from blocks of the cell to those of the brick
    BrickBox box;      ///< only its size counts
    uint32_t firstBlock;
    System system;
    int index;  ///< which end or pick
    int yarn;   ///< index into Fabric::yarns
  };
  glm::ivec3 cell{-1};
  int count = 0;
  std::array<Brick, VoxelContent::kMaxSpans> bricks;

  /// What a voxel of the cell holds, counted from its corner; `volume` is the one that they are of.
  void content(const ClothVolume& volume, glm::ivec3 voxel, VoxelContent& content) const;
};

inline ClothVolume::CellBricks ClothVolume::bricksIn(glm::ivec3 cell) const {
  Reaches reaches;
  gather(cell.y, cell.x, reaches);
  CellBricks of{.cell = cell, .count = reaches.count, .bricks = {}};
  for (int i = 0; i < reaches.count; ++i) {
    const Reach& reach = reaches.entries[i];
    of.bricks[i] = {reach.shift, reach.brick->box, reach.brick->firstBlock, reach.system, reach.index, reach.yarn};
  }
  return of;
}

inline bool ClothVolume::locate(glm::vec3 inCell_mm, glm::ivec3& cell, glm::ivec3& voxel) const {
  const glm::vec3 cellsOn = glm::floor(inCell_mm * glm::vec3(perCell_));
  cell += glm::ivec3(cellsOn);
  if (static_cast<unsigned>(cell.x) >= static_cast<unsigned>(cells_.x) ||
      static_cast<unsigned>(cell.y) >= static_cast<unsigned>(cells_.y) || cell.z != 0)
    return false;
  const glm::vec3 inVoxels = (inCell_mm - cellsOn * glm::vec3(cell_mm_)) * glm::vec3(perVoxel_);
  voxel = glm::clamp(glm::ivec3(inVoxels), glm::ivec3(0), grid_.cell - 1);
  return true;
}

inline void ClothVolume::CellBricks::content(const ClothVolume& volume, glm::ivec3 voxel, VoxelContent& content) const {
  content.count = 0;
  content.end = cell.x;
  content.pick = cell.y;
  content.voxel = cell * volume.grid_.cell + voxel;
  for (int i = 0; i < count; ++i) {
    const Brick& brick = bricks[i];
    const int number = brick.box.number((voxel >> 2) + brick.shift);
    if (number < 0) continue;
    const BrickBlock& block = volume.blocks_[brick.firstBlock + static_cast<uint32_t>(number)];
    const auto components = block.at(numberInBlock(voxel), volume.components_);
    if (!components.empty()) content.spans[content.count++] = {components, brick.system, brick.index, brick.yarn};
  }
}

/// A ray that is about to march through a piece, cell by cell. All in numbers that are counted from the cell, so that
/// floats will do. Leaves alone: grid().level is 0. Rays that are not finite meet nothing. As RayInPiece, but for its
/// three axes side by side.
class ClothVolume::CellMarch {
 public:
  /// For t in [t0, t1] of the ray origin + t direction: cloth space, direction of any length.
  CellMarch(const ClothVolume& volume, glm::vec3 origin, glm::vec3 direction, float t0, float t1)
      : volume_(&volume),
        o_{origin.x, origin.y, origin.z - static_cast<double>(volume.grid_.zLower_mm), 0},
        d_{direction.x, direction.y, direction.z, 0},
        t_(std::max(t0, std::numeric_limits<float>::lowest())),
        tEnd_(t1) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    if (!(t0 < t1) || !std::isfinite(glm::dot(origin, glm::vec3(1)) + glm::dot(direction, glm::vec3(1)))) return;
    const Float64x4 size = numbersOf(volume.cell_mm_ * glm::dvec3(volume.cells_));
    const Float64x4 d = d_;
    const Int64x4 moves = d != 0, within = (o_ >= 0) & (o_ < size);
    inverse_ = 1 / (moves ? d : broadcast<Float64x4>(1));
    const Float64x4 a = -o_ * inverse_, b = (size - o_) * inverse_, far = broadcast<Float64x4>(kFar);
    const Float64x4 enter = moves ? least(a, b) : (within ? -far : far), leave = moves ? most(a, b) : far;
    t_ = std::max({t_, enter[0], enter[1], enter[2]});
    tEnd_ = std::min({tEnd_, leave[0], leave[1], leave[2]});
    inPiece_ = t_ < tEnd_;
    constexpr double kNever = 1e30;  // a face so far off is never come to
    inverse_ = moves ? most(broadcast<Float64x4>(-kNever), least(inverse_, broadcast<Float64x4>(kNever)))
                     : broadcast<Float64x4>(kNever);
    if (inPiece_) enterCell(truncated(numbersWithin(o_ + t_ * d_, volume.perCell_, volume.cells_)));
  }
  bool inPiece() const { return inPiece_; }

  // In the piece:
  float enter() const { return static_cast<float>(t_); }     ///< of the ray's t
  float leave() const { return static_cast<float>(tEnd_); }  ///< beyond enter()
  glm::ivec3 cell() const { return {cell_[0], cell_[1], cell_[2]}; }
  /// The voxel in which it comes into the piece, counted from the corner of its cell.
  glm::ivec3 voxel() const {
    const Int32x4 voxel = truncated(numbersWithin(inCell_ + t_ * d_, volume_->perVoxel_, volume_->grid_.cell));
    return {voxel[0], voxel[1], voxel[2]};
  }
  /// The ray's origin, from the corner of the cell that it is in.
  glm::vec3 start_mm() const { return {inCell_[0], inCell_[1], inCell_[2]}; }
  /// 1 / its direction; huge where it does not move.
  glm::vec3 inverse() const { return {inverse_[0], inverse_[1], inverse_[2]}; }
  /// 1 where it moves to greater coordinates, else 0; where it does not move, 1.
  glm::ivec3 upwards() const { return {d_[0] < 0 ? 0 : 1, d_[1] < 0 ? 0 : 1, d_[2] < 0 ? 0 : 1}; }
  /// Goes to the next cell in an axis; false where that leaves the piece.
  bool leaveCell(int axis) {
    Int32x4 next = cell_;
    next[axis] += d_[axis] > 0 ? 1 : -1;
    enterCell(next);
    return static_cast<unsigned>(next[axis]) < static_cast<unsigned>(volume_->cells_[axis]);
  }

 private:
  static Float64x4 numbersOf(glm::dvec3 v) { return Float64x4{v.x, v.y, v.z, 1}; }
  /// Lengths in units of which there are so many.
  static Float64x4 numbersWithin(Float64x4 length, glm::dvec3 perLength, glm::ivec3 count) {
    return most(Float64x4{}, least(length * numbersOf(perLength), numbersOf(glm::dvec3(count - 1))));
  }
  void enterCell(Int32x4 cell) {
    cell_ = cell;
    inCell_ = o_ - __builtin_convertvector(cell, Float64x4) * numbersOf(volume_->cell_mm_);
  }

  const ClothVolume* volume_;
  // In double: at the far side of a wide cloth a float's step is no longer small beside a voxel.
  Float64x4 o_, d_, inverse_{}, inCell_{};
  double t_, tEnd_;  ///< where it comes into the piece, and leaves it
  Int32x4 cell_{};
  bool inPiece_ = false;
};

}  // namespace loomlight
