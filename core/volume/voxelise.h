#pragma once

#include "core/volume/brick.h"
#include "core/volume/voxel_grid.h"

namespace loomlight {

/// Voxelises the fibres of one key; a pure function of its arguments, the same bytes on every run. Every segment is
/// clipped exactly to the (half-open) voxels it crosses, whose length densities are the sums; per voxel one component
/// for each ply, at most two. At every level lambda integrates to the length of the strands: what rounding lambda to a
/// Component takes from some voxels is given to others, so that what is left is the rounding of the smallest (below
/// 1e-6 in a brick of a few hundred voxels, at most 2.5e-4 of a level with one voxel).
Brick voxelise(const CellStrands& strands, System system, const VoxelGrid& grid);

}  // namespace loomlight
