#include "core/volume/build/voxelise.h"

#include <utility>

namespace loomlight {

Brick Voxeliser::operator()(const CellStrands& strands, System system) {
  std::vector<Brick::Level> levels;
  levels.reserve(static_cast<size_t>(grid_.levels));
  filler_.fill(strands, system, grid_, levels_[0]);
  levels.push_back(levels_[0].fit(encoder_));
  for (int i = 1; i < grid_.levels; ++i) {
    levels_[i % 2].resetToCoarser(levels_[(i - 1) % 2]);
    levels.push_back(levels_[i % 2].fit(encoder_));
  }
  return {std::move(levels), strands.segments()};
}

Brick voxelise(const CellStrands& strands, System system, const VoxelGrid& grid) {
  return Voxeliser(grid)(strands, system);
}

}  // namespace loomlight
