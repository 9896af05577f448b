#pragma once

#include <cstddef>

namespace loomlight {

/// A range of memory that grows and shrinks without ever moving: addresses are reserved at once, memory is taken for
/// those in use alone. Not to be changed by two threads at a time; what is in use may be read meanwhile.
class AddressSpace {
 public:
  /// Where a process may not have so many addresses, it reserves a small share of those it may. Throws std::bad_alloc.
  explicit AddressSpace(size_t bytes);
  ~AddressSpace();
  AddressSpace(const AddressSpace&) = delete;
  AddressSpace& operator=(const AddressSpace&) = delete;

  void* data() const { return data_; }
  /// Makes the first so many bytes usable; new ones are 0. What lies well beyond is given back to the system. Throws
  /// std::bad_alloc where addresses or memory do not suffice.
  void resize(size_t bytes);

 private:
  void* data_ = nullptr;
  size_t reserved_ = 0, usable_ = 0;
};

}  // namespace loomlight
