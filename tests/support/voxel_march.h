#pragma once

#include <algorithm>
#include <limits>

#include "core/volume/traverse/cloth_volume.h"

namespace loomlight {

/// One ray on its way through a piece, in plain numbers: what the lanes of render/walk are held against. It stops at
/// each voxel with content, and goes on from there when it is asked to.
///
/// Voxels are half-open: a ray within a face sees those on its upper side. Cells are crossed block by block of 4 x 4 x
/// 4 voxels, and only where a block holds anything voxel by voxel. Where a ray crosses a face is computed anew for
/// each, from where it starts in the cell, so that no error adds up. Cost: one block read for each yarn in reach of the
/// cell, at every block; these yarns are looked up on entering a cell.
class ClothVolume::March : public RayInPiece {
 public:
  /// For t in [t0, t1] of the ray origin + t direction: cloth space, direction of any length.
  March(const ClothVolume& volume, glm::vec3 origin, glm::vec3 direction, float t0, float t1)
      : RayInPiece(volume, origin, direction, t0, t1), perCell_(volume.grid_.perCell()) {
    for (int axis = 0; axis < 3; ++axis) never_[axis] = d_[axis] != 0 ? 0 : std::numeric_limits<double>::infinity();
    if (!inPiece_) return;
    start();
    openBlock();
  }

  /// Goes to the next voxel with content. False where t1 is reached, or the piece left.
  bool next() {
    while (inPiece_) {
      // The faces of a block are faces of its voxels, computed alike, so the walk cannot step out of the block.
      while (inBlock_) {
        const int axis = nearest(tVoxel_), number = numberInBlock(voxel_);
        const double tLeave = std::min(tVoxel_[axis], tLeaveBlock_);
        enter_ = static_cast<float>(t_);
        leave_ = static_cast<float>(tLeave);
        // A step of no length is that of a ray through an edge, or one that starts on a face.
        const bool found = (occupied_ >> number & 1) != 0 && enter_ < leave_;
        if (found) {
          volume_->look(reaches_, number, content_);
          content_.voxel = cell_ * perCell_ + voxel_;
        }
        t_ = std::max(t_, tLeave);
        inBlock_ = tVoxel_[axis] < tLeaveBlock_;
        if (inBlock_) leaveVoxel(axis);
        if (found) return true;
      }
      t_ = std::max(t_, tLeaveBlock_);
      inPiece_ = tBlock_[side_] < tEnd_ && leaveBlock(side_);
      if (inPiece_) openBlock();
    }
    return false;
  }

  // Of the voxel that it stands at, until it goes on:
  const VoxelContent& content() const { return content_; }
  float enter() const { return enter_; }  ///< of the ray's t
  float leave() const { return leave_; }  ///< beyond enter()

 private:
  static int nearest(const glm::dvec3& t) {
    const int axis = t.y < t.x ? 1 : 0;
    return t.z < t[axis] ? 2 : axis;
  }

  /// Goes to the block at t.
  void start() {
    const Int32x4 cell = cellAtStart();
    for (int axis = 0; axis < 3; ++axis) {
      cell_[axis] = cell[axis];
      enterCell(axis);
      block_[axis] = voxelAt(axis) >> 2;
      tBlock_[axis] = faceAhead(axis, lastVoxel(axis));
    }
    gather();
  }

  void gather() {
    content_.end = cell_.x;
    content_.pick = cell_.y;
    volume_->gather(cell_.y, cell_.x, reaches_);
  }

  /// Sees what the block holds, and goes to its voxel at t if there is anything.
  void openBlock() {
    occupied_ = volume_->openBlock(reaches_, block_);
    side_ = nearest(tBlock_);
    tLeaveBlock_ = std::min(tBlock_[side_], tEnd_);
    inBlock_ = occupied_ != 0 && tLeaveBlock_ > t_;
    if (inBlock_ && !knowsVoxel_) findVoxel();
    knowsVoxel_ = inBlock_;
  }

  /// Crosses the block's face in an axis; false if this leaves the piece.
  bool leaveBlock(int axis) {
    const int step = 2 * upwards_[axis] - 1, count = (perCell_[axis] + 3) >> 2;
    block_[axis] += step;
    const bool leavesCell = static_cast<unsigned>(block_[axis]) >= static_cast<unsigned>(count);
    if (leavesCell) {
      cell_[axis] += step;
      if (static_cast<unsigned>(cell_[axis]) >= static_cast<unsigned>(volume_->cells_[axis])) return false;
      block_[axis] = upwards_[axis] ? 0 : count - 1;
      enterCell(axis);
    }
    tBlock_[axis] = faceAhead(axis, lastVoxel(axis));
    voxel_[axis] = firstVoxel(axis);
    tVoxel_[axis] = faceAhead(axis, voxel_[axis]);
    if (leavesCell) gather();
    return true;
  }

  /// The voxel of the block at t: in the block, whatever rounding says.
  void findVoxel() {
    for (int axis = 0; axis < 3; ++axis) {
      voxel_[axis] = std::clamp(voxelAt(axis), 4 * block_[axis], std::min(4 * block_[axis] + 3, perCell_[axis] - 1));
      tVoxel_[axis] = faceAhead(axis, voxel_[axis]);
    }
  }
  void leaveVoxel(int axis) {
    voxel_[axis] += 2 * upwards_[axis] - 1;
    tVoxel_[axis] = faceAhead(axis, voxel_[axis]);
  }

  void enterCell(int axis) { inCell_[axis] = o_[axis] - cell_[axis] * volume_->cell_mm_[axis]; }

  int voxelAt(int axis) const {
    const double leaf = (inCell_[axis] + t_ * d_[axis]) * volume_->perVoxel_[axis];
    return std::clamp(static_cast<int>(leaf), 0, volume_->grid_.cell[axis] - 1) >> volume_->grid_.level;
  }
  /// Of the block, those that the ray enters and leaves it by.
  int firstVoxel(int axis) const { return std::min(4 * block_[axis] + 3 * (1 - upwards_[axis]), perCell_[axis] - 1); }
  int lastVoxel(int axis) const { return std::min(4 * block_[axis] + 3 * upwards_[axis], perCell_[axis] - 1); }
  double faceAhead(int axis, int v) const {
    const int leaf = std::min((v + upwards_[axis]) << volume_->grid_.level, volume_->grid_.cell[axis]);
    return (leaf * volume_->voxel_mm_[axis] - inCell_[axis]) * inverse_[axis] + never_[axis];
  }

  glm::ivec3 perCell_;
  glm::dvec3 never_{0};  ///< infinite in the axes that the ray does not move along

  glm::ivec3 cell_{0}, block_{0}, voxel_{0};  ///< block and voxel: in their cell
  glm::dvec3 inCell_{0};                      ///< the ray's origin, from the corner of the cell
  glm::dvec3 tBlock_{0}, tVoxel_{0};          ///< where the ray crosses the faces ahead of block and voxel
  double tLeaveBlock_ = 0;
  int side_ = 0;           ///< the axis in which it leaves the block
  uint64_t occupied_ = 0;  ///< which voxels of the block hold anything
  bool inBlock_ = false;
  bool knowsVoxel_ = false;  ///< whether the voxel is that at t, without looking for it

  Reaches reaches_;
  VoxelContent content_;
  float enter_ = 0, leave_ = 0;
};

}  // namespace loomlight
