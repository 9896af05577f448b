#include "app/export/file_set.h"

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

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

/// Names of what is removed from a folder, in that order.
class Removals {
 public:
  explicit Removals(const fs::path& folder) { inotify_add_watch(events_, folder.c_str(), IN_DELETE); }
  ~Removals() { close(events_); }
  Removals(const Removals&) = delete;
  Removals& operator=(const Removals&) = delete;

  std::vector<std::string> take() {
    alignas(inotify_event) char bytes[1 << 16];
    const ssize_t length = read(events_, bytes, sizeof bytes);
    std::vector<std::string> names;
    for (ssize_t at = 0; at < length;) {
      const auto* const event = reinterpret_cast<const inotify_event*>(bytes + at);
      if (event->mask & IN_DELETE) names.emplace_back(event->name);
      at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    }
    return names;
  }

 private:
  int events_ = inotify_init1(IN_NONBLOCK);
};

// Who is killed while it removes what another killed program has left must not leave what nobody knows any more.
TEST_F(FileSetTest, RemovesTheLockOfWhatIsLeftLast) {
  const fs::path left = fs::path(folder()) / ".tile.unfinished-gone00";
  fs::create_directories(left / "textures");
  for (const char* name : {"a", "b", "c", "d", ".lock", "e", "f", "g", "h"}) std::ofstream(left / name) << "left";
  Removals removals(left);
  const FileSet set(folder(), "tile");
  EXPECT_FALSE(fs::exists(left));
  const std::vector<std::string> removed = removals.take();
  ASSERT_EQ(removed.size(), 10u);
  EXPECT_EQ(removed.back(), ".lock");
}

TEST_F(FileSetTest, FollowsLinksAndKeepsPermissions) {
  write("far", "old");
  fs::permissions(fs::path(folder()) / "far", fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read);
  fs::create_symlink("far", fs::path(folder()) / "a");
  FileSet set(folder(), "tile");
  writeFileAtomically(set.add("a"), "new");
  set.place();
  EXPECT_TRUE(fs::is_symlink(fs::path(folder()) / "a"));
  EXPECT_EQ(read("far"), "new");
  EXPECT_EQ(fs::status(fs::path(folder()) / "far").permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read);
}

/// A rename would fail when others have been moved already.
TEST_F(FileSetTest, RefusesALinkToAnotherDiskBeforeAnythingIsMoved) {
  const auto isOnAnother = [this](const fs::path& disk) {
    struct stat here{}, there{};
    return ::stat(disk.c_str(), &there) == 0 && ::stat(folder().c_str(), &here) == 0 && here.st_dev != there.st_dev &&
           ::access(disk.c_str(), W_OK) == 0;
  };
  const std::vector<fs::path> disks = {"/dev/shm", "/tmp", "/var/tmp", "/run", fs::current_path()};
  const auto disk = std::find_if(disks.begin(), disks.end(), isOnAnother);
  if (disk == disks.end()) GTEST_SKIP() << "there is no other disk here";
  const fs::path far = *disk / ("loomlight-" + fs::path(folder()).filename().string());
  std::ofstream(far) << "old";
  write("a", "old");
  fs::create_symlink(far, fs::path(folder()) / "b");
  FileSet set(folder(), "tile");
  for (const char* name : {"a", "b"}) writeFileAtomically(set.add(name), "new");
  const std::string said = test::messageOf<InputError>([&] { set.place(); });
  EXPECT_NE(said.find("expected a file on the disk of the folder"), std::string::npos) << said;
  EXPECT_EQ(read("a"), "old");
  fs::remove(far);
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
