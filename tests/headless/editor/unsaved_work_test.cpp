/// Nothing of the designer's is lost by a key too many, nor by an editor that ends badly: questions about unsaved work,
/// files that would be replaced, and work that is left behind.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/model/user_folders.h"
#include "core/fabric/json/fabric_json.h"
#include "tests/headless/editor/messages.h"
#include "tests/headless/editor/small_cloth.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

class UnsavedWork : public testing::Test {
 protected:
  void untilAsked() { untilSaid(editor, "has changes that are not saved"); }
  /// A cloth that lies there, and is not open.
  std::string written(const std::string& name) {
    const std::string other = editor.homeFile(name + ".json");
    writeFabric(smallCloth(name), other);
    return other;
  }

  HeadlessEditor editor{{960, 600, 1}};
};

/// The work is still unsaved then, so the next attempt asks again.
TEST_F(UnsavedWork, EscapeFromTheQuestionDoesNothing) {
  editor.start(smallCloth("One"));
  editor.turnACrossing();
  editor.key("ctrl+n");
  untilAsked();
  editor.key("Escape");
  editor.untilNoDialogIsOpen();
  EXPECT_EQ(editor.fact("name"), "One");
  EXPECT_EQ(editor.fact("dirty"), "yes");
  editor.key("ctrl+n");
  untilAsked();
}

TEST_F(UnsavedWork, EnterSavesBeforeAnythingElse) {
  const std::string file = editor.start(smallCloth("One"));
  editor.turnACrossing();
  const Weave before = readFabric(file).weave;
  editor.key("ctrl+n");
  untilAsked();
  editor.key("Return");
  editor.until("a new cloth is there", [&] { return editor.fact("name") != "One"; });
  EXPECT_NE(readFabric(file).weave, before) << "work was thrown away by a key";
}

/// A new cloth has no file yet: it is asked for, and then the other one opens.
TEST_F(UnsavedWork, SavingFirstMayTakeAName) {
  const std::string other = written("Two"), begun = editor.homeFile("begun.json");
  editor.startWithoutFile(smallCloth("One"));
  editor.turnACrossing();
  editor.key("ctrl+o");
  editor.nameFile(other);
  untilAsked();
  editor.key("Return");
  editor.until("a file is asked for", [&] { return editor.shows("browser.name"); });
  editor.nameFile(begun);
  editor.until("the other one is open", [&] { return editor.fact("name") == "Two"; });
  ASSERT_TRUE(fs::exists(begun)) << "what was there was not saved";
  EXPECT_EQ(readFabric(begun).name, "One");
}

TEST_F(UnsavedWork, AFileIsReplacedByTheButtonAndByNoKey) {
  const std::string taken = written("One");
  editor.start(smallCloth("Two"));
  const std::string old = test::bytesOf(taken);
  editor.key("ctrl+shift+s");
  editor.nameFile(taken);
  editor.key("Return");
  editor.key("Return");
  EXPECT_EQ(test::bytesOf(taken), old) << "a key that was pressed again replaced a file";
  editor.click("browser.ok");
  editor.until("it is replaced by its button", [&] { return editor.fact("file") == taken; });
  EXPECT_EQ(readFabric(taken).name, "Two") << "it was not replaced";
}

TEST_F(UnsavedWork, SnapshotsAreWrittenBesideEachOther) {
  Fabric cloth = smallCloth("Two");
  cloth.render.width = 24;
  cloth.render.height = 16;
  cloth.render.samplesPerPixel = 1;
  editor.start(cloth);
  for (const std::string name : {"Two.png", "Two 2.png"}) {
    editor.key("ctrl+p");
    editor.click("snapshot.start");
    editor.until("the snapshot is there", [&] { return editor.fact("snapshot.outcome").starts_with("Saved"); });
    EXPECT_TRUE(editor.fact("snapshot.outcome").ends_with("/" + name)) << editor.fact("snapshot.outcome");
    editor.click("snapshot.close");
    editor.untilNoDialogIsOpen();
  }
}

/// Copies of unsaved work, by whomever.
std::vector<fs::path> keptCopies() {
  std::vector<fs::path> copies;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(stateFolder(), none))
    if (entry.path().extension() == ".json") copies.push_back(entry.path());
  return copies;
}

/// Also where a later process has its number, as after a restart of the machine: here it is this one. An editor that is
/// killed in truth is in tests/e2e/editor/killed_editor_test.py, and one that begins with a draft, which has a dialog
/// of its own, in tests/e2e/editor/unsaved_work_test.py.
TEST_F(UnsavedWork, IsTakenUpThatAKilledEditorLeft) {
  const std::string two = editor.start(smallCloth("Two"), "two.json");
  editor.turnACrossing();
  editor.until("a copy is kept", [] { return !keptCopies().empty(); });
  editor.crash();
  const std::vector<fs::path> copies = keptCopies();
  ASSERT_EQ(copies.size(), 1u);
  const Weave weave = readFabric(copies[0].string()).weave;
  EXPECT_NE(weave, readFabric(two).weave) << "the copy is of older work";
  fs::rename(copies[0], stateFolder() / ("autosave-" + std::to_string(getpid()) + ".json"));
  editor.start(smallCloth("One"), "one.json");
  untilSaid(editor, "Take it up again?");
  editor.key("Return");
  editor.until("it is taken up", [&] { return editor.fact("dirty") == "yes" && editor.fact("name") == "Two"; });
  EXPECT_EQ(editor.fact("file"), "") << "it would be saved into a file that was not its own";
  editor.key("ctrl+z");
  EXPECT_EQ(editor.fact("name"), "Two") << "the only copy of it is gone by a key";
  EXPECT_EQ(editor.fact("dirty"), "yes");
  const std::string again = editor.homeFile("again.json");
  editor.key("ctrl+s");
  editor.nameFile(again);
  editor.until("it is saved", [&] { return editor.fact("dirty") == "no"; });
  EXPECT_EQ(readFabric(again).weave, weave) << "another cloth was taken up";
}

}  // namespace
}  // namespace loomlight
