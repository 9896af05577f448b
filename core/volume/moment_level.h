#pragma once

#include <cstdint>
#include <vector>

#include "core/volume/brick.h"
#include "core/volume/fibre_moments.h"
#include "core/volume/voxel_grid.h"

namespace loomlight {

/// One level of a brick while it is made: the moments of every ply in every voxel, before anything is rounded. A dense
/// index over the box of the brick leads to chains of moments, one per ply, so that memory follows what is occupied.
class MomentLevel {
 public:
  /// The box of voxels [lower, lower + extent).
  MomentLevel(int level, glm::ivec3 lower, glm::ivec3 extent);

  /// Where voxel (x, y, z) of the level has its chain; strides() from one to the next.
  int64_t indexOf(glm::ivec3 v) const {
    v -= lower_;
    return (static_cast<int64_t>(v.z) * extent_.y + v.y) * extent_.x + v.x;
  }
  glm::i64vec3 strides() const { return {1, extent_.x, static_cast<int64_t>(extent_.x) * extent_.y}; }

  /// The moments of a ply (0..255) with fibres of a material in the voxel at this index; made where there are none.
  FibreMoments& at(int64_t index, uint8_t ply, uint8_t material);

  /// The same moments, each summed into the voxel of the next level.
  MomentLevel coarser(const VoxelGrid& grid) const;

  /// Fitted, rounded and packed.
  Brick::Level fit(const VoxelGrid& grid) const;

 private:
  struct Link {
    int32_t next;
    uint8_t ply, material;
  };
  FibreMoments& append(int64_t index, uint8_t ply, uint8_t material);

  int level_;
  glm::ivec3 lower_, extent_;
  std::vector<int32_t> heads_;  ///< per voxel, into links_ and moments_; -1 is none
  std::vector<Link> links_;
  std::vector<FibreMoments> moments_;
};

inline FibreMoments& MomentLevel::at(int64_t index, uint8_t ply, uint8_t material) {
  for (int32_t i = heads_[index]; i >= 0; i = links_[i].next)
    if (links_[i].ply == ply && links_[i].material == material) return moments_[i];
  return append(index, ply, material);
}

}  // namespace loomlight
