#include "core/volume/build/voxelise.h"

namespace loomlight {

Brick Voxeliser::operator()(const CellStrands& strands, System system) {
  filler_.fill(strands, system, grid_.atLevel(0), levels_[0]);
  for (int level = 1; level <= grid_.level; ++level) levels_[level % 2].resetToCoarser(levels_[(level - 1) % 2]);
  return levels_[grid_.level % 2].fit(encoder_, strands.segments());
}

Brick voxelise(const CellStrands& strands, System system, const VoxelGrid& grid) {
  return Voxeliser(grid)(strands, system);
}

}  // namespace loomlight
