#pragma once

#include <array>

#include "core/volume/build/leaf_filler.h"
#include "core/volume/build/voxel_grid.h"
#include "core/volume/pool/brick.h"

namespace loomlight {

/// Voxelises the fibres of one key; a pure function of its arguments, the same bytes on every run. Every segment is
/// clipped exactly to the (half-open) voxels it crosses, whose length densities are the sums; per voxel one component
/// for each ply, at most two; in a coarser voxel those of its leaves, summed before anything is rounded. Lambda
/// integrates to the length of the strands: what rounding lambda to a Component takes from some voxels is given to
/// others, so that what is left is the rounding of the smallest (below 1e-6 in a brick of a few hundred voxels, at
/// most 2.5e-4 of a level with one voxel).
Brick voxelise(const CellStrands& strands, System system, const VoxelGrid& grid);

/// voxelise() for one brick after another of a grid; keeps its memory from brick to brick. One for each thread.
class Voxeliser {
 public:
  explicit Voxeliser(const VoxelGrid& grid) : grid_(grid) {}
  Brick operator()(const CellStrands& strands, System system);

 private:
  VoxelGrid grid_;
  LeafFiller filler_;
  std::array<MomentLevel, 2> levels_;  ///< the present one and the next, in turn
  ComponentEncoder encoder_;
};

}  // namespace loomlight
