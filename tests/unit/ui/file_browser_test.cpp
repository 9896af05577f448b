#include "ui/dialogs/file_browser.h"

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

namespace fs = std::filesystem;

/// A memory stick may have been pulled out: the name must not become one in the working directory.
TEST(FileBrowser, BeginsInTheNearestFolderThatIsThere) {
  const test::ScratchFolder scratch;
  const fs::path home = scratch.file("home"), sticks = scratch.file("sticks");
  fs::create_directories(home);
  fs::create_directories(sticks);
  const std::vector<FileBrowser::Bookmark> places = {{"Gone", scratch.file("gone")}, {"Home", home}};
  FileBrowser browser;
  const auto begins = [&](FileBrowser::Purpose purpose, const fs::path& start) {
    browser.show(purpose, "File", {".json"}, start, places);
    return browser.chosen();
  };
  using Purpose = FileBrowser::Purpose;
  EXPECT_EQ(begins(Purpose::save, sticks / "stick/folder/cloth.json"), (sticks / "cloth.json").string());
  EXPECT_EQ(begins(Purpose::save, "/no such folder/of ours/cloth.json"), (home / "cloth.json").string());
  EXPECT_EQ(begins(Purpose::open, sticks / "stick/folder"), "") << "no file is named like the folder that is gone";
}

}  // namespace
}  // namespace loomlight
