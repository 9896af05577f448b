/// Files that are none, among the designer's and among those that the editor keeps for itself, which are as hostile as
/// anything else on a disk: pipes, links to themselves, devices that never end, bytes that mean nothing. And texts,
/// which are read as what they are.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "app/editor/model/user_folders.h"
#include "tests/headless/editor/messages.h"
#include "tests/headless/editor/small_cloth.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

/// Whoever opened one to read would wait for somebody who writes.
void makePipe(const fs::path& file) {
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
}

/// Of no format.
void putBytesOfAllKinds(const fs::path& file) {
  std::string bytes;
  for (int i = 0; i < 25'600; ++i) bytes.push_back(static_cast<char>(i & 255));
  test::putBytes(file.string(), bytes);
}

class SpoiltFolders : public testing::Test {
 protected:
  SpoiltFolders() {
    for (const fs::path& folder : {presetFolder(), viewFolder(), stateFolder()}) fs::create_directories(folder);
  }

  HeadlessEditor editor{{960, 720, 1}};
};

/// By its name it is the copy of a process that cannot be, so it is offered.
TEST_F(SpoiltFolders, LeftWorkThatIsNoneIsNotTakenUp) {
  makePipe(stateFolder() / "autosave-2000000000.json");
  const std::string file = editor.start(smallCloth("Blue"));
  untilSaid(editor, "Take it up again?");
  editor.click("message.answer_2");
  answerOnceSaid(editor, "expected a regular file");
  EXPECT_EQ(editor.fact("file"), file) << "something has taken the place of the cloth";
}

/// Presets are read in the order of their names: once that of the cloth is there, the others have been tried.
TEST_F(SpoiltFolders, PresetsThatAreNoneAreNotOfferedAndOthersAreKept) {
  makePipe(presetFolder() / "pipe.json");
  fs::create_symlink("loop.json", presetFolder() / "loop.json");
  fs::create_directory(presetFolder() / "tags");  // in the way of the file of that name
  putBytesOfAllKinds(presetFolder() / "binary.json");
  const auto expectNoneOffered = [&] {
    for (const char* name : {"pipe", "loop", "binary"})
      EXPECT_FALSE(editor.shows(std::string("presets.card/") + name)) << name << " is offered";
  };
  editor.start(smallCloth("twill"));
  editor.key("ctrl+b");
  editor.until("the presets are shown", [&] { return editor.shows("presets.card/Denim"); });
  expectNoneOffered();
  editor.click("presets.keep");
  editor.until("a preset is kept all the same", [&] { return editor.shows("presets.card/twill"); });
  expectNoneOffered();
  editor.click("presets.close");
  editor.untilNoDialogIsOpen();
}

/// Nor where it has such a name as the editor gives to its views. One disk is read and written in turn: when another
/// view is on it, these have been tried.
TEST_F(SpoiltFolders, PicturesThatAreNoneAreNoKeptViews) {
  for (const char* name : {"broken.png", "view-00000000000000000001-1.png"}) putBytesOfAllKinds(viewFolder() / name);
  for (const char* name : {"pipe.png", "view-00000000000000000002-1.png"}) makePipe(viewFolder() / name);
  const auto pictures = [] {
    std::set<fs::path> files;
    for (const auto& entry : fs::directory_iterator(viewFolder()))
      if (entry.path().extension() == ".png") files.insert(entry.path());
    return files;
  };
  const std::set<fs::path> before = pictures();
  editor.start(smallCloth("Blue"));
  editor.untilPictured();
  EXPECT_FALSE(editor.shows("snapshot.item_0")) << "a picture that is none is a kept view";
  editor.key("k");
  editor.until("a view is kept all the same", [&] { return editor.shows("snapshot.item_0") && pictures() != before; });
  editor.frame();  // in which what has been read is taken
  editor.frame();  // in which it would be shown
  EXPECT_FALSE(editor.shows("snapshot.item_1")) << "a picture that is none is a kept view beside it";
}

class FilesThatAreNone : public testing::Test {
 protected:
  /// The cloth has been edited once: one that was opened in its place would have the number of none.
  FilesThatAreNone() : file(editor.start(smallCloth("Blue"))) {
    editor.edits("the cloth is edited", [&] { editor.click("draft.cell_0_0"); });
    editor.saved();
    before = editor.number("revision");
  }
  void open(const std::string& name) {
    editor.key("ctrl+o");
    editor.nameFile(editor.homeFile(name));
  }
  void expectTheCloth() {
    EXPECT_EQ(editor.number("revision"), before) << "a file that is none became the cloth";
    EXPECT_EQ(editor.fact("file"), file);
  }

  HeadlessEditor editor{{960, 600, 1}};
  const std::string file;
  uint64_t before = 0;
};

TEST_F(FilesThatAreNone, AreRefusedByNameAndTheClothStays) {
  makePipe(editor.homeFile("pipe.json"));
  fs::create_symlink("/dev/zero", editor.homeFile("endless.wif"));
  putBytesOfAllKinds(editor.homeFile("binary.wif"));
  const std::string cut("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0", 18);  // in the midst of its header
  test::putBytes(editor.homeFile("cut.png"), cut);
  for (const char* name : {"pipe.json", "endless.wif", "binary.wif", "cut.png"}) {
    open(name);
    answerOnceSaid(editor, name);
  }
  expectTheCloth();
}

/// The browser says why, and stays; Escape leaves it.
TEST_F(FilesThatAreNone, ALinkToItselfIsNotOpened) {
  const std::string loop = std::string(200, 'o') + ".json";  // so long that what is said is told as a fact, too
  fs::create_symlink(loop, editor.homeFile(loop));
  open(loop);
  editor.until("the browser says why",
               [&] { return editor.fact("shortened.browser.problem").find(loop) != std::string::npos; });
  EXPECT_TRUE(editor.shows("browser.name")) << "the browser takes it for a file";
  editor.key("Escape");
  editor.key("Escape");
  editor.untilNoDialogIsOpen();
  expectTheCloth();
}

/// Of a folder with more than anybody would look through as much is listed as takes no time, and it is said.
TEST_F(FilesThatAreNone, AFolderOfTooMuchIsCut) {
  const fs::path folder = editor.homeFile("much");
  fs::create_directory(folder);
  for (int i = 0; i < 20'001; ++i) test::putBytes((folder / std::to_string(i)).string(), "");
  editor.key("ctrl+o");
  editor.until("the browser is open", [&] { return editor.shows("browser.name"); });
  EXPECT_FALSE(editor.shows("browser.cut"));
  editor.click("browser.entry/much");
  editor.until("the folder is said to be cut", [&] { return editor.shows("browser.cut"); });
}

/// WIF drafts come by mail as texts; what is none of ours is named.
TEST(DraftByMail, IsReadAsWhatItIs) {
  HeadlessEditor editor{{960, 600, 1}};
  editor.start(smallCloth("Blue"));
  std::string draft = editor.homeFile("draft.wif.txt");
  test::putBytes(draft,
                 "[WIF]\nVersion=1.1\n[WEAVING]\nShafts=2\nTreadles=2\n[WARP]\nThreads=2\n[WEFT]\nThreads=2\n"
                 "[THREADING]\n1=1\n2=2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n[TEXT]\nTitle=By mail\n");
  const auto open = [&] {
    editor.key("ctrl+o");
    editor.nameFile(draft);
  };
  open();
  editor.until("the draft is open", [&] { return editor.fact("name") == "By mail"; });
  editor.click("wif.close");
  editor.untilNoDialogIsOpen();
  for (const auto& [ending, said] :
       {std::pair("abc", "a draft (.wif, .plm, .dtx, .twa)"), std::pair("wpo", "as WIF in WeavePoint")}) {
    const std::string other = editor.homeFile(std::string("draft.") + ending);
    fs::rename(draft, other);
    draft = other;
    open();
    untilSaid(editor, said);
    editor.key("Return");
    editor.untilNoDialogIsOpen();
  }
}

}  // namespace
}  // namespace loomlight
