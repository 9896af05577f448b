#include "core/volume/pool/brick_pool.h"

#include <algorithm>

namespace loomlight {
namespace {

// Of components and blocks 4 GiB each, which any volume is content with (ClothVolume::kMaxBytes): so 32 bits address
// their bytes too, as vector instructions do.
constexpr uint32_t kMostComponents = 0xFFFFFFFF / sizeof(Component), kMostBlocks = 0xFFFFFFFF / sizeof(BrickBlock),
                   kMostEntries = uint32_t{1} << 28;

/// Into the cells on either side, across the yarn.
void findReach(const Brick& brick, System system, BrickPool::Entry& entry) {
  const int axis = system == System::warp ? 0 : 1;
  const int first = brick.box.lower[axis], perCell = (brick.cell[axis] + 3) >> 2;
  for (size_t i = 0; i < brick.blocks.size(); ++i) {
    if (!brick.blocks[i].occupied) continue;
    const auto number = static_cast<int>(i);
    const glm::ivec3 size = brick.box.size;
    const int b = first + (axis == 0 ? number % size.x : number / size.x % size.y);
    entry.reachesBelow |= b < 0;
    entry.reachesAbove |= b >= perCell;
  }
}

}  // namespace

BrickPool::BrickPool(glm::ivec3 cell)
    : cell_(cell), entries_(kMostEntries), blocks_(kMostBlocks), components_(kMostComponents) {
  entries_.data()[entries_.take(1)] = {};
}

BrickPool::Id BrickPool::add(const Brick& brick, System system) {
  Entry entry;
  entry.box = brick.box;
  entry.components = static_cast<uint32_t>(brick.components.size());
  entry.voxels = static_cast<uint32_t>(brick.view().voxels());
  entry.segments = brick.segments;
  entry.holders = 1;
  findReach(brick, system, entry);
  const auto count = static_cast<uint32_t>(brick.blocks.size());
  Id id = kNone;
  {
    std::lock_guard lock(mutex_);
    id = entries_.take(1);
    try {
      takeRanges(count, entry);
    } catch (...) {
      entries_.giveBack(id, 1);
      throw;
    }
    entries_.data()[id] = entry;
  }
  std::copy(brick.components.begin(), brick.components.end(), components_.data() + entry.firstComponent);
  std::transform(brick.blocks.begin(), brick.blocks.end(), blocks_.data() + entry.firstBlock, [&](BrickBlock block) {
    block.first += entry.firstComponent;
    return block;
  });
  return id;
}

/// For so many blocks and the entry's components.
void BrickPool::takeRanges(uint32_t blocks, Entry& entry) {
  entry.firstBlock = blocks_.take(blocks);
  try {
    entry.firstComponent = components_.take(entry.components);
  } catch (...) {
    blocks_.giveBack(entry.firstBlock, blocks);
    throw;
  }
}

void BrickPool::hold(std::span<const Id> bricks) {
  std::lock_guard lock(mutex_);
  for (const Id brick : bricks)
    if (brick != kNone) ++entries_.data()[brick].holders;
}

void BrickPool::release(std::span<const Id> bricks) {
  std::lock_guard lock(mutex_);
  for (const Id brick : bricks) {
    if (brick == kNone) continue;
    const Entry& entry = entries_.data()[brick];
    if (--entries_.data()[brick].holders > 0) continue;
    blocks_.giveBack(entry.firstBlock, static_cast<uint32_t>(entry.box.blocks()));
    components_.giveBack(entry.firstComponent, entry.components);
    entries_.giveBack(brick, 1);
  }
}

BrickView BrickPool::view(Id brick) const {
  const Entry& entry = (*this)[brick];
  return {cell_,
          entry.box,
          blocks() + entry.firstBlock,
          components(),
          {components() + entry.firstComponent, entry.components},
          entry.segments};
}

}  // namespace loomlight
