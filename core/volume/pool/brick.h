#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/volume/pool/component.h"

namespace loomlight {

/// 4 x 4 x 4 voxels of a brick. A voxel holds no, one or two components (two where plies meet). Its components start at
/// first + (set bits below it in occupied) + (the same in second).
struct BrickBlock {
  uint64_t occupied = 0;
  uint64_t second = 0;
  uint32_t first = 0;

  /// The components of a voxel, by its number x + 4 y + 16 z in the block; `components` is what `first` counts from.
  std::span<const Component> at(int voxel, const Component* components) const {
    const uint64_t bit = uint64_t{1} << voxel;
    if (!(occupied & bit)) return {};
    const uint64_t below = bit - 1;
    const auto index = first + std::popcount(occupied & below) + std::popcount(second & below);
    return {components + index, second & bit ? size_t{2} : size_t{1}};
  }
};

/// The blocks of a brick: a box of them, those that are empty included, x before y before z. Blocks are counted from
/// the corner of each cell, and the last ones of a cell may be cut by its edge: so the blocks of all bricks that reach
/// into a cell coincide, and a traversal can test them together.
struct BrickBox {
  glm::ivec3 lower{0};  ///< first block
  glm::ivec3 size{0};   ///< in blocks

  size_t blocks() const { return static_cast<size_t>(size.x) * size.y * size.z; }
  /// The number of a block, by its place counted from the first one; -1 where it lies outside.
  int number(glm::ivec3 place) const {
    const bool inside = static_cast<unsigned>(place.x) < static_cast<unsigned>(size.x) &&
                        static_cast<unsigned>(place.y) < static_cast<unsigned>(size.y) &&
                        static_cast<unsigned>(place.z) < static_cast<unsigned>(size.z);
    return inside ? (place.z * size.y + place.y) * size.x + place.x : -1;
  }
  bool operator==(const BrickBox&) const = default;
};

/// The fibres of one yarn in one crossing cell, in sparse voxels, wherever they are kept. Voxel coordinates are those
/// of the cell's grid; a yarn that spills sideways has voxels at coordinates below 0 or beyond the cell's size.
struct BrickView {
  glm::ivec3 cell{1};  ///< voxels of one cell
  BrickBox box;
  const BrickBlock* blocks = nullptr;
  const Component* first = nullptr;       ///< what BrickBlock::first counts from
  std::span<const Component> components;  ///< of all its voxels
  size_t segments = 0;                    ///< fibre segments it was made of

  /// The components of voxel v; empty where there are none or v is outside.
  std::span<const Component> at(glm::ivec3 v) const;
  size_t voxels() const;  ///< occupied ones; counts them
  size_t bytes() const { return box.blocks() * sizeof(BrickBlock) + components.size_bytes(); }
  /// The same content, wherever it is kept.
  friend bool operator==(const BrickView& a, const BrickView& b);
};

/// A brick as it is made, before a pool takes it.
struct Brick {
  glm::ivec3 cell{1};
  BrickBox box;
  std::vector<BrickBlock> blocks;
  std::vector<Component> components;
  size_t segments = 0;

  BrickView view() const { return {cell, box, blocks.data(), components.data(), components, segments}; }
  std::span<const Component> at(glm::ivec3 v) const { return view().at(v); }
};

}  // namespace loomlight
