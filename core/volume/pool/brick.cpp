#include "core/volume/pool/brick.h"

namespace loomlight {

Brick::Brick(std::vector<Level> levels, size_t segments) : levels_(std::move(levels)), segments_(segments) {
  for (const Block& block : levels_.front().grid) voxels_ += static_cast<size_t>(std::popcount(block.occupied));
}

size_t Brick::bytes() const {
  size_t bytes = sizeof(Brick) + levels_.capacity() * sizeof(Level);
  for (const Level& level : levels_)
    bytes += level.grid.capacity() * sizeof(Block) + level.components.capacity() * sizeof(Component);
  return bytes;
}

size_t Brick::components() const {
  return levels_.front().components.size();
}

}  // namespace loomlight
