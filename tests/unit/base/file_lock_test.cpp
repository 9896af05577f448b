#include "core/base/file_lock.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

TEST(FileLock, OnlyWhatIsLockedIsHeld) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("a.lock");
  EXPECT_FALSE(FileLock::isHeld(file)) << "there is none";
  {
    const auto lock = FileLock::make(file);
    ASSERT_TRUE(lock);
    EXPECT_TRUE(FileLock::isHeld(file));
    EXPECT_FALSE(FileLock::make(file)) << "a second time";
  }
  EXPECT_FALSE(FileLock::isHeld(file)) << "the file is left, unlocked";
}

}  // namespace
}  // namespace loomlight
