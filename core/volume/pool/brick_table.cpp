#include "core/volume/pool/brick_table.h"

#include <algorithm>
#include <utility>

namespace loomlight {
namespace {

/// Into the cells on either side, across the yarn.
BrickTable::Slot slotOf(const Brick& brick, System system) {
  BrickTable::Slot slot{&brick, false, false};
  const int axis = system == System::warp ? 0 : 1;
  const int first = brick.lower[axis], perCell = brick.blocksPerCell()[axis];
  for (size_t i = 0; i < brick.grid.size(); ++i) {
    if (!brick.grid[i].occupied) continue;
    const auto block = static_cast<int>(i);
    const int b = first + (axis == 0 ? block % brick.blocks.x : block / brick.blocks.x % brick.blocks.y);
    slot.reachesBelow |= b < 0;
    slot.reachesAbove |= b >= perCell;
  }
  return slot;
}

}  // namespace

/// Whoever changes a table is the only one to hold it, unless it was copied: nobody else can come by it meanwhile.
BrickTable::Data& BrickTable::own() {
  if (data_.use_count() > 1) {
    data_ = std::make_shared<Data>(*data_);
    slots_ = data_->slots.data();
  }
  return *data_;
}

void BrickTable::place(size_t kind, System system, std::shared_ptr<const Brick> brick) {
  Data& data = own();
  const Slot& slot = data.slots[kind] = slotOf(*brick, system);
  data.anyReachesBelow |= slot.reachesBelow;
  data.anyReachesAbove |= slot.reachesAbove;
  data.bricks[kind] = std::move(brick);
}

void BrickTable::lend(size_t kind, size_t other) {
  Data& data = own();
  data.slots[other] = data.slots[kind];
  data.bricks[other] = data.bricks[kind];
}

void BrickTable::resize(size_t kinds) {
  if (kinds == size()) return;
  Data& data = own();
  data.bricks.resize(kinds);
  data.slots.resize(kinds);
  slots_ = data.slots.data();
}

void BrickTable::clear() {
  const size_t kinds = size();
  data_ = std::make_shared<Data>();
  resize(kinds);
}

void BrickTable::keepOnly(const std::vector<uint64_t>& cellsOf) {
  bool dropped = false;
  for (size_t kind = 0; kind < size(); ++kind) {
    if (cellsOf[kind] > 0 || !data_->bricks[kind]) continue;
    Data& data = own();
    data.bricks[kind] = nullptr;
    data.slots[kind] = {};
    dropped = true;
  }
  if (!dropped) return;
  const auto any = [this](bool Slot::* reaches) {
    return std::any_of(data_->slots.begin(), data_->slots.end(), [&](const Slot& slot) { return slot.*reaches; });
  };
  data_->anyReachesBelow = any(&Slot::reachesBelow);
  data_->anyReachesAbove = any(&Slot::reachesAbove);
}

size_t BrickTable::bytes() const {
  return sizeof(Data) + data_->bricks.capacity() * sizeof(data_->bricks[0]) +
         data_->slots.capacity() * sizeof(data_->slots[0]);
}

size_t BrickTable::bytesBeside(const BrickTable& other) const {
  if (data_ == other.data_) return 0;
  size_t sum = bytes();
  for (size_t kind = 0; kind < size(); ++kind) {
    const auto& brick = (*this)[kind];
    if (brick && !(kind < other.size() && other[kind] == brick)) sum += brick->bytes();
  }
  return sum;
}

}  // namespace loomlight
