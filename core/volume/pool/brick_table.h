#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/volume/pool/brick_pool.h"

namespace loomlight {

/// The brick of each of a number of kinds of cells, or none. A pointer to copy: copies share all until one is changed.
class BrickTable {
 public:
  BrickTable() = default;
  explicit BrickTable(std::shared_ptr<BrickPool> pool) { start(std::move(pool), 0); }

  size_t size() const { return data_->bricks.size(); }
  std::shared_ptr<BrickPool> pool() const { return data_->bricks.pool(); }
  /// kNone where it is missing.
  BrickPool::Id operator[](size_t kind) const { return data_->bricks[kind]; }
  /// What the traversal needs.
  const BrickPool::Entry& entry(size_t kind) const { return entries_[bricks_[kind]]; }
  bool anyReachesBelow() const { return data_->anyReachesBelow; }
  bool anyReachesAbove() const { return data_->anyReachesAbove; }
  size_t bytes() const { return sizeof(Data) + data_->bricks.bytes(); }  ///< without the bricks
  /// With the bricks, but without what `other` has in the same places.
  size_t bytesBeside(const BrickTable& other) const;

  void place(size_t kind, BrickPool::Id brick);
  void resize(size_t kinds);
  /// As many kinds, no bricks; those to come are of this pool.
  void clear(std::shared_ptr<BrickPool> pool) { start(std::move(pool), size()); }
  /// Leaves those bricks only whose kinds have cells, these being counted for so many kinds at a time.
  void keepOnly(const std::vector<uint64_t>& cellsOf, size_t together);

 private:
  struct Data {
    BrickList bricks;
    bool anyReachesBelow = false, anyReachesAbove = false;
  };
  void start(std::shared_ptr<BrickPool> pool, size_t kinds);
  Data& own();

  std::shared_ptr<Data> data_ = std::make_shared<Data>();
  // Of the list and its pool, for the traversal:
  const BrickPool::Id* bricks_ = nullptr;
  const BrickPool::Entry* entries_ = nullptr;
};

}  // namespace loomlight
