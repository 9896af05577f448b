#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace loomlight {

/// A list of shared immutable values that is cheap to copy and to change in a few places: the pointers to them lie in
/// blocks, which copies have in common until they differ.
template <class T>
class SharedList {
 public:
  using Pointer = std::shared_ptr<const T>;

  SharedList() = default;
  explicit SharedList(std::span<const Pointer> values) : size_(values.size()) {
    for (size_t first = 0; first < values.size(); first += kBlock) {
      const auto block = std::make_shared<Block>();
      const auto some = values.subspan(first, std::min(kBlock, values.size() - first));
      std::copy(some.begin(), some.end(), block->begin());
      blocks_.push_back(block);
    }
  }

  size_t size() const { return size_; }
  const Pointer& operator[](size_t i) const { return (*blocks_[i / kBlock])[i % kBlock]; }
  std::vector<Pointer> all() const {
    std::vector<Pointer> values;
    for (size_t i = 0; i < size_; ++i) values.push_back((*this)[i]);
    return values;
  }
  /// Costs a copy of a block; many are better set before the list is made.
  void set(size_t i, Pointer value) {
    const auto changed = std::make_shared<Block>(*blocks_[i / kBlock]);
    (*changed)[i % kBlock] = std::move(value);
    blocks_[i / kBlock] = changed;
  }

  /// visit(pointer) for each that is not at the same place of `other` too.
  template <class Visit>
  void forEachBeside(const SharedList& other, const Visit& visit) const {
    for (size_t i = 0; i < size_; ++i) {
      if (i % kBlock == 0 && i < other.size_ && blocks_[i / kBlock] == other.blocks_[i / kBlock]) {
        i += kBlock - 1;  // the whole block
      } else if (i >= other.size_ || (*this)[i] != other[i]) {
        visit((*this)[i]);
      }
    }
  }
  size_t bytes() const { return blocks_.size() * (sizeof(Block) + sizeof(blocks_[0])); }  ///< without the values

 private:
  static constexpr size_t kBlock = 64;
  using Block = std::array<Pointer, kBlock>;
  size_t size_ = 0;
  std::vector<std::shared_ptr<const Block>> blocks_;
};

}  // namespace loomlight
