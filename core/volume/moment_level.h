#pragma once

#include <cstdint>
#include <vector>

#include "core/volume/brick.h"
#include "core/volume/fibre_moments.h"
#include "core/volume/voxel_grid.h"

namespace loomlight {

/// One level of a brick while it is made: the moments of every ply in every voxel, before anything is rounded. A dense
/// index over the blocks of the brick leads to chains of moments, one per ply, so that memory follows what is occupied.
/// Voxels are numbered block by block: 64 * (number of the block in Brick::Level::grid) + number in the block.
class MomentLevel {
 public:
  /// Leaves: the blocks of all voxels of a box, of which `last` is the last one.
  MomentLevel(const VoxelGrid& grid, glm::ivec3 first, glm::ivec3 last);
  /// No leaves: a brick of nothing.
  explicit MomentLevel(const VoxelGrid& grid) : MomentLevel(grid, 0, glm::ivec3(0), glm::ivec3(0)) {}

  /// What voxels of coordinate v in an axis add to their numbers: a voxel's is the sum over the axes.
  int32_t offset(int axis, int v) const;

  /// The moments of a ply (0..255) with fibres of a material in a voxel; made where there are none.
  FibreMoments& at(int32_t voxel, uint8_t ply, uint8_t material);

  /// The same moments, each summed into the voxel of the next level.
  MomentLevel coarser() const;

  /// Fitted, rounded and packed.
  Brick::Level fit() const;

 private:
  /// The blocks [lower, lower + blocks), counted as Brick::Level does.
  MomentLevel(const VoxelGrid& grid, int level, glm::ivec3 lower, glm::ivec3 blocks);
  struct Link {
    int32_t next;
    uint8_t ply, material;
  };
  FibreMoments& append(int32_t voxel, uint8_t ply, uint8_t material);
  glm::ivec3 blockAt(size_t number) const;

  VoxelGrid grid_;
  int level_;
  glm::ivec3 perCell_;  ///< blocks of a cell
  glm::ivec3 lower_, blocks_;
  std::vector<uint64_t> occupied_;  ///< per block
  std::vector<int32_t> heads_;      ///< per voxel, into links_ and moments_; -1 is none
  std::vector<Link> links_;
  std::vector<FibreMoments> moments_;
};

inline FibreMoments& MomentLevel::at(int32_t voxel, uint8_t ply, uint8_t material) {
  for (int32_t i = heads_[voxel]; i >= 0; i = links_[i].next)
    if (links_[i].ply == ply && links_[i].material == material) return moments_[i];
  return append(voxel, ply, material);
}

}  // namespace loomlight
