#include "app/export/file_set.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

namespace fs = std::filesystem;

class FileSetTest : public testing::Test {
 protected:
  std::string folder() const { return scratch_.path().string(); }
  void write(const std::string& name, const char* content) const { std::ofstream(scratch_.path() / name) << content; }
  std::string read(const std::string& name) const { return readFile((scratch_.path() / name).string(), 100); }
  size_t entries() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(scratch_.path()), fs::directory_iterator()));
  }

 private:
  test::ScratchFolder scratch_;
};

TEST_F(FileSetTest, IsInItsPlaceWhenAllAreMade) {
  write("a", "old");
  FileSet set(folder(), "tile");
  writeFileAtomically(set.add("a"), "new");
  EXPECT_EQ(read("a"), "old");
  writeFileAtomically(set.add("textures/b"), "new");
  set.place();
  EXPECT_EQ(read("a"), "new");
  EXPECT_EQ(read("textures/b"), "new");
}

TEST_F(FileSetTest, ThatCannotBePlacedLeavesTheOldFiles) {
  write("a", "old");
  fs::create_directory(fs::path(folder()) / "b");
  {
    FileSet set(folder(), "tile");
    writeFileAtomically(set.add("a"), "new");
    writeFileAtomically(set.add("b"), "new");
    EXPECT_THROW(set.place(), InputError) << "a folder is in the way";
  }
  EXPECT_EQ(read("a"), "old");
  EXPECT_EQ(entries(), 2u) << "nothing is left of the set";
}

TEST_F(FileSetTest, RemovesWhatAKilledProgramHasLeft) {
  fs::create_directory(fs::path(folder()) / ".tile.unfinished");
  write(".tile.unfinished/c", "half");
  {
    const FileSet set(folder(), "tile");
    EXPECT_FALSE(fs::exists(set.pathOf("c")));
  }
  EXPECT_EQ(entries(), 0u);
}

}  // namespace
}  // namespace loomlight
