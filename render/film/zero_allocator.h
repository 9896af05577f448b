#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <utility>

namespace loomlight {

/// Memory that the system promises to be zero and hands out page by page when it is first touched: a large film costs
/// nothing to make, and the threads that fill it share the cost of its pages. Elements are zero bytes; their default
/// constructors are not called.
template <class T>
struct ZeroAllocator {
  using value_type = T;

  ZeroAllocator() = default;
  template <class U>
  ZeroAllocator(const ZeroAllocator<U>&) {}

  T* allocate(size_t count) {
    void* memory = mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, size_t count) { munmap(memory, count * sizeof(T)); }

  template <class U>
  void construct(U*) {}
  template <class U, class... Arguments>
  void construct(U* element, Arguments&&... arguments) {
    ::new (static_cast<void*>(element)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const ZeroAllocator&, const ZeroAllocator&) { return true; }
};

}  // namespace loomlight
