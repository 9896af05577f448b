#include "core/base/address_space.h"

#include <sys/mman.h>

#include <new>

namespace loomlight {
namespace {

constexpr size_t kStep = size_t{1} << 20;  // memory comes and goes by so much: whole pages of any size in use

size_t roundedUp(size_t bytes) {
  return (bytes + kStep - 1) / kStep * kStep;
}

void* reserve(size_t bytes) {
  void* const data = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return data == MAP_FAILED ? nullptr : data;
}

}  // namespace

AddressSpace::AddressSpace(size_t bytes) : reserved_(roundedUp(bytes)) {
  data_ = reserve(reserved_);
  // A process with a limit needs addresses for other things too.
  for (size_t most = reserved_ / 2; !data_ && most >= kStep; most /= 2)
    if (void* const some = reserve(most)) {
      munmap(some, most);
      reserved_ = roundedUp(most / 16);
      data_ = reserve(reserved_);
    }
  if (!data_) throw std::bad_alloc();
}

AddressSpace::~AddressSpace() {
  munmap(data_, reserved_);
}

void AddressSpace::resize(size_t bytes) {
  const size_t wanted = roundedUp(bytes);
  if (wanted > reserved_) throw std::bad_alloc();
  std::byte* const first = static_cast<std::byte*>(data_);
  if (wanted > usable_) {
    if (mprotect(first + usable_, wanted - usable_, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
    usable_ = wanted;
  } else if (usable_ - wanted > usable_ / 4) {
    // Anew, so that the system takes the memory back and counts it no longer.
    if (mmap(first + wanted, usable_ - wanted, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED, -1,
             0) == MAP_FAILED)
      return;
    usable_ = wanted;
  }
}

}  // namespace loomlight
