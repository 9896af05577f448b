#include "app/export/program_folders.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

void install(const fs::path& prefix) {
  fs::create_directories(prefix / "bin");
  fs::create_directories(prefix / "share/loomlight/samples");
  std::ofstream(prefix / "bin/loomlight") << "a program";
}

TEST(ProgramFolders, FilesAreFoundFromTheProgram) {
  EXPECT_EQ(sharedFolderOf("/usr/bin/loomlight"), "/usr/share/loomlight");
  EXPECT_EQ(sharedFolderOf("/opt/cloth tools/bin/loomlight"), "/opt/cloth tools/share/loomlight");
  EXPECT_TRUE(sharedFolderOf({}).empty());
}

TEST(ProgramFolders, TheSamplesMoveWithTheTree) {
  const test::ScratchFolder scratch;
  const fs::path here(scratch.file("here")), there(scratch.file("there"));
  install(here);
  EXPECT_EQ(sampleFolder(here / "bin/loomlight"), here / "share/loomlight/samples");
  fs::rename(here, there);
  EXPECT_EQ(sampleFolder(there / "bin/loomlight"), there / "share/loomlight/samples");
  EXPECT_EQ(sampleFolder(here / "bin/loomlight"), std::nullopt);
}

TEST(ProgramFolders, AProgramWithoutItsFilesHasNoSamples) {
  const test::ScratchFolder scratch;
  const fs::path alone(scratch.file("alone"));
  install(alone);
  fs::remove_all(alone / "share");
  std::ofstream(alone / "share") << "no folder";
  EXPECT_EQ(sampleFolder(alone / "bin/loomlight"), std::nullopt);
  EXPECT_EQ(sampleFolder({}), std::nullopt);
}

/// This test is a program of the build tree, beside the editor.
TEST(ProgramFolders, TheBuildTreeIsLaidOutLikeAnInstalledOne) {
  EXPECT_TRUE(fs::is_regular_file(programFile()));
  const auto samples = sampleFolder();
  ASSERT_TRUE(samples);
  EXPECT_TRUE(fs::equivalent(*samples, LOOMLIGHT_SAMPLES));
}

}  // namespace
}  // namespace loomlight
