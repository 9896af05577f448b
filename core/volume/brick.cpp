#include "core/volume/brick.h"

namespace loomlight {

size_t Brick::bytes() const {
  size_t bytes = sizeof(Brick) + levels_.capacity() * sizeof(Level);
  for (const Level& level : levels_)
    bytes += level.grid.capacity() * sizeof(Block) + level.components.capacity() * sizeof(Component);
  return bytes;
}

size_t Brick::voxels() const {
  size_t count = 0;
  for (const Block& block : levels_.front().grid) count += static_cast<size_t>(std::popcount(block.occupied));
  return count;
}

size_t Brick::components() const {
  return levels_.front().components.size();
}

}  // namespace loomlight
