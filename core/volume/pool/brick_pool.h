#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "core/base/arena.h"
#include "core/volume/pool/brick.h"

namespace loomlight {

/// All bricks of one grid that anybody holds: their blocks lie in one arena, their components in another, so that a
/// traversal comes from a brick's number to a voxel's components by offsets alone. A brick stays where it is until
/// nobody holds it any more; then its ranges are given back. Volumes that come out of one another by edits share a
/// pool. May be used by several threads; bricks that are held may be read meanwhile. About 8 bytes a component, 24
/// bytes a block of 64 voxels and 64 bytes a brick.
class BrickPool {
 public:
  /// A brick's number while it is held.
  using Id = uint32_t;
  static constexpr Id kNone = 0;  ///< a brick without blocks
  struct Entry {
    BrickBox box;
    uint32_t firstBlock = 0;
    bool reachesBelow = false;  ///< into the cell beside it across the yarn, on the lower side
    bool reachesAbove = false;
    // What a traversal does not need:
    uint32_t firstComponent = 0, components = 0;
    uint32_t voxels = 0;   ///< occupied ones
    uint32_t holders = 0;  ///< how often it is held
    uint64_t segments = 0;
    size_t bytes() const {
      return sizeof(Entry) + box.blocks() * sizeof(BrickBlock) + size_t{components} * sizeof(Component);
    }
  };

  /// For bricks of cells with so many voxels.
  explicit BrickPool(glm::ivec3 cell);

  /// Copies a brick, which is held once then; `system`: of the yarn whose it is. Throws std::bad_alloc.
  Id add(const Brick& brick, System system);
  /// Each once more, or once less; kNone may be among them.
  void hold(std::span<const Id> bricks);
  void release(std::span<const Id> bricks);

  const Entry* entries() const { return entries_.data(); }
  const BrickBlock* blocks() const { return blocks_.data(); }
  const Component* components() const { return components_.data(); }
  const Entry& operator[](Id brick) const { return entries_.data()[brick]; }
  BrickView view(Id brick) const;

 private:
  void takeRanges(uint32_t blocks, Entry& entry);

  glm::ivec3 cell_;
  std::mutex mutex_;  ///< of the arenas' ranges and the entries' holders
  Arena<Entry> entries_;
  Arena<BrickBlock> blocks_;
  Arena<Component> components_;
};

/// Bricks by some number, each held for as long as it stands here; copies hold them too.
class BrickList {
 public:
  BrickList() = default;
  BrickList(std::shared_ptr<BrickPool> pool, size_t size) : pool_(std::move(pool)), bricks_(size) {}
  BrickList(const BrickList& other) : pool_(other.pool_), bricks_(other.bricks_) {
    if (pool_) pool_->hold(bricks_);
  }
  BrickList(BrickList&&) = default;
  BrickList& operator=(BrickList other) noexcept {
    std::swap(pool_, other.pool_);
    std::swap(bricks_, other.bricks_);
    return *this;
  }
  ~BrickList() {
    if (pool_) pool_->release(bricks_);
  }

  const std::shared_ptr<BrickPool>& pool() const { return pool_; }
  size_t size() const { return bricks_.size(); }
  BrickPool::Id operator[](size_t i) const { return bricks_[i]; }
  const BrickPool::Id* data() const { return bricks_.data(); }
  size_t bytes() const { return bricks_.capacity() * sizeof(bricks_[0]); }  ///< without the bricks

  void set(size_t i, BrickPool::Id brick) {
    pool_->hold({&brick, 1});
    takeOver(i, brick);
  }
  /// A brick that the caller holds, and holds no longer. May be called by several threads, each with another i.
  void takeOver(size_t i, BrickPool::Id brick) {
    const BrickPool::Id before = std::exchange(bricks_[i], brick);
    pool_->release({&before, 1});
  }
  void resize(size_t size) {
    if (size < bricks_.size()) pool_->release(std::span(bricks_).subspan(size));
    bricks_.resize(size);
  }

 private:
  std::shared_ptr<BrickPool> pool_;
  std::vector<BrickPool::Id> bricks_;
};

}  // namespace loomlight
