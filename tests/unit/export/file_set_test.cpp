#include "app/export/file_set.h"

#include <gtest/gtest.h>
#include <unistd.h>

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

TEST_F(FileSetTest, SaysHowManyAreNewWhereOneCannotBeMoved) {
  write("b", "old");
  FileSet set(folder(), "tile");
  writeFileAtomically(set.add("a"), "new");
  set.add("b");  // and never made
  const std::string said = test::messageOf<InputError>([&] { set.place(); });
  EXPECT_NE(said.find("only 1 of 2 files"), std::string::npos) << said;
  EXPECT_EQ(read("a"), "new");
  EXPECT_EQ(read("b"), "old");
}

TEST_F(FileSetTest, RemovesWhatAKilledProgramHasLeft) {
  const auto killed = [&] {
    FileSet set(folder(), "tile");
    writeFileAtomically(set.add("c"), "half");
    ::_exit(0);
  };
  EXPECT_EXIT(killed(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(entries(), 1u) << "what it has left";
  {
    const FileSet other(folder(), "file");
  }
  EXPECT_EQ(entries(), 1u) << "it is not of that name";
  {
    const FileSet set(folder(), "tile");
  }
  EXPECT_EQ(entries(), 0u);
}

TEST_F(FileSetTest, SetsOfOneNameAreMadeAtTheSameTime) {
  FileSet first(folder(), "tile");
  writeFileAtomically(first.add("a"), "first");
  {
    FileSet second(folder(), "tile");
    writeFileAtomically(second.add("a"), "second");
    EXPECT_EQ(readFile(first.pathOf("a"), 100), "first");
    second.place();
    EXPECT_EQ(read("a"), "second");
  }
  first.place();
  EXPECT_EQ(read("a"), "first");
}

TEST_F(FileSetTest, TakesTheLongestNames) {
  const std::string name(240, 'n');
  FileSet set(folder(), name);
  writeFileAtomically(set.add(name + ".png"), "new");
  set.place();
  EXPECT_EQ(read(name + ".png"), "new");
}

}  // namespace
}  // namespace loomlight
