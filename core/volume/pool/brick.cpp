#include "core/volume/pool/brick.h"

#include <algorithm>

namespace loomlight {

std::span<const Component> BrickView::at(glm::ivec3 v) const {
  const auto cellOf = [](int i, int size) { return i < 0 ? -1 : i >= size ? 1 : 0; };
  const glm::ivec3 neighbour(cellOf(v.x, cell.x), cellOf(v.y, cell.y), 0), perCell = (cell + 3) >> 2;
  v -= neighbour * cell;
  if (glm::any(glm::lessThan(v, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(v, cell))) return {};
  const int number = box.number((v >> 2) + neighbour * perCell - box.lower);
  if (number < 0) return {};
  return blocks[number].at((v.x & 3) | (v.y & 3) << 2 | (v.z & 3) << 4, first);
}

size_t BrickView::voxels() const {
  size_t voxels = 0;
  for (const BrickBlock& block : std::span(blocks, box.blocks()))
    voxels += static_cast<size_t>(std::popcount(block.occupied));
  return voxels;
}

bool operator==(const BrickView& a, const BrickView& b) {
  const auto sameBlock = [&](const BrickBlock& x, const BrickBlock& y) {
    return x.occupied == y.occupied && x.second == y.second &&
           (x.occupied == 0 || a.first + x.first - a.components.data() == b.first + y.first - b.components.data());
  };
  return a.cell == b.cell && a.box == b.box && a.segments == b.segments &&
         std::equal(a.blocks, a.blocks + a.box.blocks(), b.blocks, sameBlock) &&
         std::ranges::equal(a.components, b.components);
}

}  // namespace loomlight
