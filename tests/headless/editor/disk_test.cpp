/// Disks that take nothing of the cloth itself: the editor says so, goes on, and the work is saved elsewhere. What is
/// written beside the cloth has tests of its own (full_disk_test.cpp), and so has a program that cannot save and
/// cannot keep its settings, in the real window (tests/e2e/editor/disk_test.py).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/fabric/json/fabric_json.h"
#include "tests/headless/editor/messages.h"
#include "tests/headless/editor/small_cloth.h"
#include "tests/support/full_disk.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

using test::FullDisk;
using testing::ElementsAre;

class ClothOnAFullDisk : public testing::Test {
 protected:
  ClothOnAFullDisk() {
    fs::create_directory(folder);
    file = editor.start(smallCloth("Blue"), "cloths/blue.json");
  }
  void untilNoCopyIsKept() {
    editor.until("the editor says that no copy is kept",
                 [&] { return editor.fact("autosave_problem").find("File too large") != std::string::npos; });
  }
  void expectUnsaved() { EXPECT_EQ(editor.fact("dirty"), "yes") << "work that is not on the disk counts as saved"; }
  std::vector<std::string> namesInFolder() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    return names;
  }

  HeadlessEditor editor{{960, 720, 1}};
  const fs::path folder = editor.home() / "cloths";
  std::string file;
};

/// The disk fills up while one works: of what was edited before there may be a copy, of what came since there is none.
TEST_F(ClothOnAFullDisk, IsNotSavedAndItsOldFileStays) {
  const std::string old = test::bytesOf(file);
  editor.turnACrossing();
  {
    const FullDisk full(FullDisk::kFewerThanAnyFile);
    editor.edits("another edit", [&] { editor.dragWidget("yarn.ply_twist_per_m", 40); });
    untilNoCopyIsKept();
    editor.key("ctrl+s");
    answerOnceSaid(editor, "File too large");
  }
  expectUnsaved();
  EXPECT_EQ(test::bytesOf(file), old) << "the old file is gone";
  EXPECT_THAT(namesInFolder(), ElementsAre("blue.json")) << "something was left beside the file";
}

TEST_F(ClothOnAFullDisk, IsNotLostByQuitting) {
  editor.turnACrossing();
  {
    const FullDisk full(FullDisk::kFewerThanAnyFile);
    editor.key("ctrl+q");
    editor.click("message.answer_2");  // Save
    answerOnceSaid(editor, "File too large");
  }
  expectUnsaved();
  EXPECT_FALSE(editor.isOver()) << "the editor ended with work that it could not save";
}

TEST_F(ClothOnAFullDisk, IsSavedElsewhereAndAllIsSafe) {
  {
    const FullDisk full(FullDisk::kFewerThanAnyFile);
    editor.turnACrossing();
    untilNoCopyIsKept();
  }
  const Fabric elsewhere = editor.savedAs((folder / "elsewhere.json").string());
  EXPECT_EQ(editor.fact("dirty"), "no");
  editor.until("all is safe", [&] { return editor.fact("autosave_problem").empty(); });
  EXPECT_NE(elsewhere.weave, readFabric(file).weave) << "the edit is not in it";
}

/// Where nobody may write a file, not even root.
TEST(ClothInAReadOnlyPlace, IsNotSaved) {
  HeadlessEditor editor{{960, 600, 1}};
  editor.start(smallCloth("Blue"));
  editor.turnACrossing();
  editor.key("ctrl+shift+s");
  editor.nameFile("/sys/cloth.json");
  answerOnceSaid(editor, "/sys/cloth.json");
  EXPECT_EQ(editor.fact("dirty"), "yes") << "work that is not on the disk counts as saved";
}

}  // namespace
}  // namespace loomlight
