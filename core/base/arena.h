#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

#include "core/base/address_space.h"

namespace loomlight {

/// Which numbers from 0 on are taken, in ranges. A range that is given back joins its free neighbours; the smallest
/// free range that is large enough is taken next. Cost: the logarithm of how many free ranges there are.
class RangeAllocator {
 public:
  /// The first of `count` numbers in a row, count > 0.
  uint32_t take(uint32_t count);
  void giveBack(uint32_t first, uint32_t count);
  uint32_t end() const { return end_; }  ///< all from here on are free

 private:
  void addFree(uint32_t first, uint32_t count);
  void dropFree(std::map<uint32_t, uint32_t>::iterator range);

  std::map<uint32_t, uint32_t> free_;               ///< counts of free ranges, by their first
  std::set<std::pair<uint32_t, uint32_t>> bySize_;  ///< the same, as count and first
  uint32_t end_ = 0;
};

/// Plain values in memory that never moves. Ranges of them are taken and given back, and addressed by
/// 32-bit offsets from its beginning. Not to be changed by two threads at a time; the values of ranges that are taken
/// may be read and written meanwhile.
template <class T>
class Arena {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  explicit Arena(uint32_t most) : space_(size_t{most} * sizeof(T)) {}

  T* data() { return static_cast<T*>(space_.data()); }
  const T* data() const { return static_cast<const T*>(space_.data()); }

  /// The offset of a range of so many values, which may be anything. Throws std::bad_alloc.
  uint32_t take(uint32_t count) {
    if (count == 0) return 0;
    const uint32_t first = ranges_.take(count);
    try {
      fit();
    } catch (...) {
      giveBack(first, count);
      throw;
    }
    return first;
  }
  void giveBack(uint32_t first, uint32_t count) {
    if (count == 0) return;
    ranges_.giveBack(first, count);
    fit();
  }

 private:
  void fit() { space_.resize(size_t{ranges_.end()} * sizeof(T)); }

  AddressSpace space_;
  RangeAllocator ranges_;
};

}  // namespace loomlight
