#include "core/volume/pool/brick_table.h"

#include <utility>

namespace loomlight {

void BrickTable::start(std::shared_ptr<BrickPool> pool, size_t kinds) {
  entries_ = pool->entries();
  data_ = std::make_shared<Data>(Data{BrickList(std::move(pool), kinds)});
  bricks_ = data_->bricks.data();
}

/// Whoever changes a table is the only one to hold it, unless it was copied: nobody else can come by it meanwhile.
BrickTable::Data& BrickTable::own() {
  if (data_.use_count() > 1) {
    data_ = std::make_shared<Data>(*data_);
    bricks_ = data_->bricks.data();
  }
  return *data_;
}

void BrickTable::place(size_t kind, BrickPool::Id brick) {
  Data& data = own();
  data.bricks.set(kind, brick);
  data.anyReachesBelow |= entries_[brick].reachesBelow;
  data.anyReachesAbove |= entries_[brick].reachesAbove;
}

void BrickTable::resize(size_t kinds) {
  if (kinds == size()) return;
  Data& data = own();
  data.bricks.resize(kinds);
  bricks_ = data.bricks.data();
}

void BrickTable::keepOnly(const std::vector<uint64_t>& cellsOf, size_t together) {
  bool dropped = false;
  for (size_t kind = 0; kind < size(); ++kind) {
    if (cellsOf[kind / together] > 0 || (*this)[kind] == BrickPool::kNone) continue;
    own().bricks.set(kind, BrickPool::kNone);
    dropped = true;
  }
  if (!dropped) return;
  data_->anyReachesBelow = data_->anyReachesAbove = false;
  for (size_t kind = 0; kind < size(); ++kind) {
    data_->anyReachesBelow |= entry(kind).reachesBelow;
    data_->anyReachesAbove |= entry(kind).reachesAbove;
  }
}

size_t BrickTable::bytesBeside(const BrickTable& other) const {
  if (data_ == other.data_) return 0;
  const bool samePool = data_->bricks.pool() == other.data_->bricks.pool();
  size_t sum = bytes();
  for (size_t kind = 0; kind < size(); ++kind)
    if ((*this)[kind] != BrickPool::kNone && !(samePool && kind < other.size() && other[kind] == (*this)[kind]))
      sum += entry(kind).bytes();
  return sum;
}

}  // namespace loomlight
