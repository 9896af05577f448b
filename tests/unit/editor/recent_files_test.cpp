#include "app/editor/model/recent_files.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

std::vector<std::string> namesOf(const std::vector<RecentFile>& files) {
  std::vector<std::string> names;
  for (const RecentFile& file : files) names.push_back(file.file);
  return names;
}

TEST(RecentFiles, TheLastOneIsFirstAndThereOnce) {
  std::vector<RecentFile> files;
  for (const char* file : {"/a", "/b", "/a", "/c"}) remember(files, file);
  EXPECT_EQ(namesOf(files), (std::vector<std::string>{"/c", "/a", "/b"}));
  forget(files, "/a");
  EXPECT_EQ(namesOf(files), (std::vector<std::string>{"/c", "/b"}));
}

TEST(RecentFiles, TheOldestGo) {
  std::vector<RecentFile> files;
  for (int i = 0; i < 30; ++i) remember(files, fmt::format("/{}", i));
  EXPECT_EQ(files.size(), kMostRecentFiles);
  EXPECT_EQ(files.front().file, "/29");
}

TEST(RecentFiles, MissingOnesAreNoticedAndFoundAgain) {
  const test::ScratchFolder folder;
  std::vector<RecentFile> files;
  remember(files, folder.file("cloth.json"));
  lookFor(files);
  EXPECT_TRUE(files[0].missing);
  std::ofstream(folder.file("cloth.json")) << "{}";
  lookFor(files);
  EXPECT_FALSE(files[0].missing);
}

}  // namespace
}  // namespace loomlight
