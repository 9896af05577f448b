#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/volume/pool/brick.h"

namespace loomlight {

/// The brick of each of a number of kinds of cells, or none. A pointer to copy: copies share all until one is changed.
class BrickTable {
 public:
  /// What the traversal needs.
  struct Slot {
    const Brick* brick = nullptr;
    bool reachesBelow = false;  ///< into the cell beside it across the yarn, on the lower side
    bool reachesAbove = false;
  };

  size_t size() const { return data_->bricks.size(); }
  const std::shared_ptr<const Brick>& operator[](size_t kind) const { return data_->bricks[kind]; }
  const Slot& slot(size_t kind) const { return slots_[kind]; }
  bool anyReachesBelow() const { return data_->anyReachesBelow; }
  bool anyReachesAbove() const { return data_->anyReachesAbove; }
  size_t bytes() const;  ///< without the bricks
  /// With the bricks, but without what `other` has in the same places.
  size_t bytesBeside(const BrickTable& other) const;

  /// `system`: of the yarns whose bricks these are.
  void place(size_t kind, System system, std::shared_ptr<const Brick> brick);
  void lend(size_t kind, size_t other);  ///< another kind has the same brick
  void resize(size_t kinds);
  void clear();  ///< as many kinds, no bricks
  /// Leaves those bricks only whose kinds have cells.
  void keepOnly(const std::vector<uint64_t>& cellsOf);

 private:
  struct Data {
    std::vector<std::shared_ptr<const Brick>> bricks;
    std::vector<Slot> slots;
    bool anyReachesBelow = false, anyReachesAbove = false;
  };
  Data& own();

  std::shared_ptr<Data> data_ = std::make_shared<Data>();
  const Slot* slots_ = nullptr;
};

}  // namespace loomlight
