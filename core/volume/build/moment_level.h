#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/volume/build/component_encoder.h"
#include "core/volume/build/voxel_grid.h"
#include "core/volume/pool/brick.h"

namespace loomlight {

/// From where to where the fibres of a ply reach in a voxel, counted in voxels from the corner of its brick's frame.
struct FibreBounds {
  static constexpr float kFar = std::numeric_limits<float>::max();
  Float32x4 lower{kFar, kFar, kFar, kFar}, upper{-kFar, -kFar, -kFar, -kFar};

  void add(Float32x4 point) {
    lower = least(lower, point);
    upper = most(upper, point);
  }
};

/// One level of a brick while it is made: the moments of every ply in every voxel, before anything is rounded. A dense
/// index over the blocks of the brick leads to chains of moments, one per ply, so that memory follows what is occupied.
/// Voxels are numbered block by block: 64 * (number of the block in Brick::blocks) + number in the block.
class MomentLevel {
 public:
  /// Nothing yet: reset() comes first. What is reset keeps its memory, so that bricks can be made one after another
  /// without asking for any.
  MomentLevel() = default;

  /// Leaves of nothing, in the blocks of a box of voxels of which `last` is the last one; bounds are counted from the
  /// lower corner of voxel `origin`.
  void reset(const VoxelGrid& leaves, glm::ivec3 first, glm::ivec3 last, glm::ivec3 origin, float fibreRadius_mm);
  /// No leaves: a brick of nothing.
  void reset(const VoxelGrid& leaves) { resetBlocks(leaves, glm::ivec3(0), glm::ivec3(0)); }
  /// The moments of the level below, each summed into the voxel that it lies in.
  void resetToCoarser(const MomentLevel& finer);

  /// What leaves from `origin` to `last` along an axis add to their numbers: a voxel's number is the sum over the axes.
  /// Before `first` it has no meaning.
  std::span<const int32_t> offsets(int axis) const { return offsets_[axis]; }

  /// What is known of the fibres of a ply in a voxel.
  struct Fibres {
    FibreMoments& moments;
    FibreBounds& bounds;  ///< of leaves alone: fibres of a coarser voxel may lie anywhere in it
  };
  /// Those of a ply (0..255) in a voxel; made where there are none.
  Fibres at(int32_t voxel, uint8_t ply);

  /// Fitted, rounded and packed, of so many fibre segments. The encoder is one that has nothing in it.
  Brick fit(ComponentEncoder& encoder, size_t segments) const;

 private:
  /// The blocks [lower, lower + blocks), counted as BrickBox does.
  void resetBlocks(const VoxelGrid& grid, glm::ivec3 lower, glm::ivec3 blocks);
  struct Link {
    int32_t next;
    uint8_t ply;
  };
  Fibres append(int32_t voxel, uint8_t ply);
  glm::ivec3 blockAt(size_t number) const;
  /// A voxel with fibres.
  struct Place {
    int32_t number;
    glm::ivec3 voxel;
    double volume_mm3;
  };
  /// Give the fibres of a voxel to the encoder; return of how many components: none, one or two.
  int encode(const Place& place, ComponentEncoder& encoder) const;
  int encodeMany(const Place& place, ComponentEncoder& encoder) const;
  /// What offsets() is made of: of voxel v of the cloth along an axis.
  int32_t offset(int axis, int v) const;
  /// Of a ply in a voxel, by where its moments and bounds stand.
  VoxelBox boxOf(size_t fibres, const Place& place) const;
  /// Of a ply in the voxel that is `step` from leaf v along an axis, v counted from `origin`.
  double lengthBeside_mm(const Place& place, int axis, int v, int step, uint8_t ply) const;

  VoxelGrid grid_;
  glm::ivec3 perCell_{1};  ///< blocks of a cell
  glm::ivec3 lower_{0}, blocks_{0};
  glm::ivec3 origin_{0};                         ///< voxel whose lower corner bounds are counted from
  glm::ivec3 first_{0};                          ///< of leaves, counted from `origin_`
  std::array<std::vector<int32_t>, 3> offsets_;  ///< by coordinate, counted from `origin_`; none above the leaves
  glm::vec3 fibreRadius_{0};                     ///< in widths of a leaf
  std::vector<uint64_t> occupied_;               ///< per block
  std::vector<int32_t> heads_;                   ///< per voxel, into links_, moments_ and bounds_; -1 is none
  std::vector<Link> links_;
  std::vector<FibreMoments> moments_;
  std::vector<FibreBounds> bounds_;
};

inline MomentLevel::Fibres MomentLevel::at(int32_t voxel, uint8_t ply) {
  for (int32_t i = heads_[voxel]; i >= 0; i = links_[i].next)
    if (links_[i].ply == ply) return {moments_[i], bounds_[i]};
  return append(voxel, ply);
}

}  // namespace loomlight
