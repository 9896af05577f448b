#include "core/volume/pool/brick.h"

namespace loomlight {

size_t Brick::bytes() const {
  return sizeof(Brick) + grid.capacity() * sizeof(Block) + components.capacity() * sizeof(Component);
}

size_t Brick::voxels() const {
  size_t voxels = 0;
  for (const Block& block : grid) voxels += static_cast<size_t>(std::popcount(block.occupied));
  return voxels;
}

}  // namespace loomlight
