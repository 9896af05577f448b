#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/volume/pool/component.h"

namespace loomlight {

/// The fibres of one yarn in one crossing cell, in sparse voxels. A voxel holds no, one or two components (two where
/// plies meet). Voxel coordinates are those of the cell's grid; a yarn that spills sideways has voxels at coordinates
/// below 0 or beyond the cell's size. About 6 bytes a component and 24 bytes a block of 64 voxels.
struct Brick {
  /// 4 x 4 x 4 voxels. A voxel's components start at first + (set bits below it in occupied) + (the same in second).
  struct Block {
    uint64_t occupied = 0;
    uint64_t second = 0;
    uint32_t first = 0;
    bool operator==(const Block&) const = default;
  };

  // Blocks are counted from the corner of each cell, and the last ones of a cell may be cut by its edge: so the blocks
  // of all bricks that reach into a cell coincide, and a traversal can test them together.
  glm::ivec3 cell{1};    ///< voxels of one cell
  glm::ivec3 lower{0};   ///< first block
  glm::ivec3 blocks{0};  ///< extent, in blocks
  std::vector<Block> grid;
  std::vector<Component> components;
  size_t segments = 0;  ///< fibre segments it was made of

  glm::ivec3 blocksPerCell() const { return (cell + 3) >> 2; }
  /// The block at a place counted from the first one; null where there is none.
  const Block* blockFromLower(glm::ivec3 b) const;
  /// The components of a voxel of a block, by its number x + 4 y + 16 z there.
  std::span<const Component> at(const Block& block, int voxel) const;
  /// The components of voxel v; empty where there are none or v is outside. Cost: one block and one or two components
  /// read.
  std::span<const Component> at(glm::ivec3 v) const;

  size_t bytes() const;   ///< all that it keeps, itself included
  size_t voxels() const;  ///< occupied ones; counts them
  friend bool operator==(const Brick&, const Brick&) = default;
};

inline const Brick::Block* Brick::blockFromLower(glm::ivec3 b) const {
  if (static_cast<unsigned>(b.x) >= static_cast<unsigned>(blocks.x) ||
      static_cast<unsigned>(b.y) >= static_cast<unsigned>(blocks.y) ||
      static_cast<unsigned>(b.z) >= static_cast<unsigned>(blocks.z))
    return nullptr;
  return &grid[(b.z * blocks.y + b.y) * blocks.x + b.x];
}

inline std::span<const Component> Brick::at(const Block& block, int voxel) const {
  const uint64_t bit = uint64_t{1} << voxel;
  if (!(block.occupied & bit)) return {};
  const uint64_t below = bit - 1;
  const auto index = block.first + std::popcount(block.occupied & below) + std::popcount(block.second & below);
  return {components.data() + index, block.second & bit ? size_t{2} : size_t{1}};
}

inline std::span<const Component> Brick::at(glm::ivec3 v) const {
  const auto cellOf = [](int i, int size) { return i < 0 ? -1 : i >= size ? 1 : 0; };
  const glm::ivec3 neighbour(cellOf(v.x, cell.x), cellOf(v.y, cell.y), 0);
  v -= neighbour * cell;
  if (glm::any(glm::lessThan(v, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(v, cell))) return {};
  const Block* b = blockFromLower((v >> 2) + neighbour * blocksPerCell() - lower);
  if (!b) return {};
  return at(*b, (v.x & 3) | (v.y & 3) << 2 | (v.z & 3) << 4);
}

}  // namespace loomlight
