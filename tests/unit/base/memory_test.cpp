#include "core/base/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <vector>

namespace loomlight {
namespace {

// Sanitizers bring allocators of their own, which are not asked.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

size_t residentBytes() {
  std::ifstream file("/proc/self/statm");
  size_t size = 0, resident = 0;
  file >> size >> resident;
  return resident * static_cast<size_t>(sysconf(_SC_PAGE_SIZE));
}

/// Small things that die below one that lives: the allocator keeps their pages, as it gives back only what lies on top.
TEST(ReleaseFreeMemory, HandsBackWhatLiesBelowTheLiving) {
  constexpr size_t kCount = 400'000, kBytes = 160;
  std::vector<std::unique_ptr<char[]>> small(kCount);
  for (auto& one : small) {
    one = std::make_unique<char[]>(kBytes);
    *const_cast<volatile char*>(one.get()) = 1;  // memory that nobody uses a compiler may leave out
  }
  const auto living = std::make_unique<char[]>(kBytes);
  for (auto& one : small) one.reset();
  const size_t before = residentBytes();
  releaseFreeMemory();
  EXPECT_LT(residentBytes() + kCount * kBytes / 2, before);
}

#endif

}  // namespace
}  // namespace loomlight
