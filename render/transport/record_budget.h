#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

namespace loomlight {

/// The memory that records may take, in bytes. Threads share it.
class RecordBudget {
 public:
  explicit RecordBudget(size_t bytes) : most_(bytes) {}

  size_t taken() const { return taken_; }
  /// Whether there was no room for something.
  bool isExhausted() const { return exhausted_.load(std::memory_order_relaxed); }

  /// So that `elements` may become so many without growing. It grows by a quarter, so that little memory is held in
  /// reserve. False when there is none left.
  template <class T>
  bool makeRoom(std::vector<T>& elements, size_t count) {
    const size_t now = elements.capacity();
    if (count <= now) return true;
    const size_t then = std::max(count, now + now / 4);
    const size_t grown = (then - now) * sizeof(T);
    if (taken_.fetch_add(grown) + grown > most_) {
      taken_ -= grown;
      exhausted_ = true;
      return false;
    }
    elements.reserve(then);
    return true;
  }
  /// Gives back what `elements` do not use.
  template <class T>
  void shrink(std::vector<T>& elements) {
    const size_t before = elements.capacity();
    elements.shrink_to_fit();
    taken_ -= (before - elements.capacity()) * sizeof(T);
  }

 private:
  size_t most_;
  std::atomic<size_t> taken_{0};
  std::atomic<bool> exhausted_{false};
};

}  // namespace loomlight
