#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace loomlight {

/// What was found out about the cells that were asked for of late: rays come into the same few again and again. Cells
/// whose numbers agree in their last five bits push each other out. For one thread. `Entry` has a member `cell`, which
/// is -1 before it is filled.
template <class Entry>
class RecentCells {
 public:
  /// Calls fill(entry) where the entry is of another cell, or of none.
  template <class Fill>
  const Entry& at(glm::ivec3 cell, const Fill& fill) {
    Entry& known = entries_[static_cast<size_t>(cell.x & 31) | static_cast<size_t>(cell.y & 31) << 5];
    if (known.cell == cell) return known;
    fill(known);
    known.cell = cell;
    return known;
  }

 private:
  std::vector<Entry> entries_ = std::vector<Entry>(1024);
};

}  // namespace loomlight
