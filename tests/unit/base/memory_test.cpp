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

constexpr size_t kBytes = 160;

/// Written to, as a compiler may leave out memory that nobody uses.
std::unique_ptr<char[]> small() {
  auto memory = std::make_unique<char[]>(kBytes);
  *const_cast<volatile char*>(memory.get()) = 1;
  return memory;
}

/// Small things that die below one that lives: the allocator keeps their pages, as it gives back only what lies on top.
TEST(ReleaseFreeMemory, HandsBackWhatLiesBelowTheLiving) {
  constexpr size_t kCount = 400'000;
  std::vector<std::unique_ptr<char[]>> dying(kCount);
  for (auto& one : dying) one = small();
  const auto living = small();
  for (auto& one : dying) one.reset();
  const size_t before = residentBytes();
  releaseFreeMemory();
  EXPECT_LT(residentBytes() + kCount * kBytes / 2, before);
}

#endif

}  // namespace
}  // namespace loomlight
