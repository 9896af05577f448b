#include "core/base/arena.h"

#include <iterator>
#include <limits>
#include <new>

// How it works. Free ranges are kept twice: by where they begin, to join neighbours when one is given back, and by
// size, to find the smallest that is large enough. A free range at the end shortens what is in use instead.
namespace loomlight {

uint32_t RangeAllocator::take(uint32_t count) {
  if (const auto fit = bySize_.lower_bound({count, 0}); fit != bySize_.end()) {
    const auto [size, first] = *fit;
    dropFree(free_.find(first));
    if (size > count) addFree(first + count, size - count);
    return first;
  }
  if (count > std::numeric_limits<uint32_t>::max() - end_) throw std::bad_alloc();
  end_ += count;
  return end_ - count;
}

void RangeAllocator::giveBack(uint32_t first, uint32_t count) {
  auto next = free_.lower_bound(first);
  if (next != free_.begin()) {
    const auto before = std::prev(next);
    if (before->first + before->second == first) {
      first = before->first;
      count += before->second;
      dropFree(before);
    }
  }
  if (next != free_.end() && next->first == first + count) {
    count += next->second;
    dropFree(next);
  }
  if (first + count == end_)
    end_ = first;
  else
    addFree(first, count);
}

void RangeAllocator::addFree(uint32_t first, uint32_t count) {
  free_.emplace(first, count);
  bySize_.emplace(count, first);
}

void RangeAllocator::dropFree(std::map<uint32_t, uint32_t>::iterator range) {
  bySize_.erase({range->second, range->first});
  free_.erase(range);
}

}  // namespace loomlight
