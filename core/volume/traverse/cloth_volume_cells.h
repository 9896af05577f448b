#pragma once

// How rays come into the cells of ClothVolume, apart from its declaration; included by cloth_volume.h.

#include <array>
#include <cmath>

#include "core/volume/traverse/cloth_volume_rays.h"

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

inline std::optional<ClothVolume::PlaceInVoxel> ClothVolume::locate(glm::ivec3 cell, glm::vec3 inCell_mm) const {
  const glm::vec3 cellsOn = glm::floor(inCell_mm * glm::vec3(perCell_));
  cell += glm::ivec3(cellsOn);
  if (static_cast<unsigned>(cell.x) >= static_cast<unsigned>(cells_.x) ||
      static_cast<unsigned>(cell.y) >= static_cast<unsigned>(cells_.y) || cell.z != 0)
    return std::nullopt;
  const glm::vec3 inVoxels = (inCell_mm - cellsOn * glm::vec3(cell_mm_)) * glm::vec3(perVoxel_);
  const glm::ivec3 voxel = glm::clamp(glm::ivec3(inVoxels), glm::ivec3(0), grid_.cell - 1);
  // What rounding puts beyond counts as inside.
  return PlaceInVoxel{cell, voxel, glm::clamp(inVoxels - glm::vec3(voxel), 0.0f, std::nextafter(1.0f, 0.0f))};
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
/// floats will do. Leaves alone: grid().level is 0.
class ClothVolume::CellMarch : public RayInPiece {
 public:
  /// For t in [t0, t1] of the ray origin + t direction: cloth space, direction of any length.
  CellMarch(const ClothVolume& volume, glm::vec3 origin, glm::vec3 direction, float t0, float t1)
      : RayInPiece(volume, origin, direction, t0, t1) {
    if (inPiece_) enterCell(cellAtStart());
  }

  // In the piece:
  float enter() const { return static_cast<float>(t_); }     ///< of the ray's t
  float leave() const { return static_cast<float>(tEnd_); }  ///< beyond enter()
  glm::ivec3 cell() const { return {cell_[0], cell_[1], cell_[2]}; }
  /// The voxel in which it comes into the piece, counted from the corner of its cell.
  glm::ivec3 voxel() const {
    const Int32x4 voxel = numbersWithin(inCell_ + t_ * d_, volume_->perVoxel_, volume_->grid_.cell);
    return {voxel[0], voxel[1], voxel[2]};
  }
  /// The ray's origin, from the corner of the cell that it is in.
  glm::vec3 start_mm() const { return {inCell_[0], inCell_[1], inCell_[2]}; }
  /// 1 / its direction; huge where it hardly moves.
  glm::vec3 inverse() const {
    constexpr double kNever = 1e30;  // a face so far off is never come to
    const Float64x4 d = d_, never = broadcast<Float64x4>(kNever);
    const Float64x4 inverse = d != 0 ? most(-never, least(inverse_, never)) : never;
    return {inverse[0], inverse[1], inverse[2]};
  }
  /// 0 where it moves to lesser coordinates, else 1.
  glm::ivec3 upwards() const { return upwards_; }
  /// Goes to the next cell in an axis; false where that leaves the piece.
  bool leaveCell(int axis) {
    Int32x4 next = cell_;
    next[axis] += 2 * upwards_[axis] - 1;
    enterCell(next);
    return static_cast<unsigned>(next[axis]) < static_cast<unsigned>(volume_->cells_[axis]);
  }

 private:
  void enterCell(Int32x4 cell) {
    cell_ = cell;
    inCell_ = o_ - __builtin_convertvector(cell, Float64x4) * numbersOf(volume_->cell_mm_);
  }

  Float64x4 inCell_{};  ///< its origin, from the corner of the cell
  Int32x4 cell_{};
};

}  // namespace loomlight
