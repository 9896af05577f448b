/// Disks that take nothing while the editor writes what is not the cloth itself (of that: disk_test.cpp): it says so,
/// what was there is there as it was, nothing lies beside it, and once there is room all goes on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "app/editor/model/user_folders.h"
#include "tests/headless/editor/written_beside.h"
#include "tests/support/full_disk.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

using test::FullDisk;
using testing::HasSubstr;

class OnAFullDisk : public testing::Test, protected EditorBesideAFolder {
 protected:
  /// Of a dialog that renders, with all it needs.
  void leavesTheOldFile(const std::string& dialog, const std::string& file) {
    const std::map<std::string, std::string> before = filesIn(out);
    {
      const FullDisk full(FullDisk::kFewerThanAnyFile);
      editor.click(dialog + ".start");
      untilSaid(dialog + ".outcome", "File too large");
    }
    EXPECT_THAT(editor.fact(dialog + ".outcome"), HasSubstr(fs::path(file).filename().string()));
    EXPECT_EQ(filesIn(out), before);
  }
  /// Once there is room.
  void replaces(const std::string& dialog, const std::string& file) {
    editor.click(dialog + ".start");
    editor.until("it is written", [&] {
      const std::string outcome = editor.fact(dialog + ".outcome");
      return outcome.starts_with("Written") || outcome.starts_with("Saved");
    });
    EXPECT_NE(test::bytesOf(file), kOld);
    close(dialog);
  }
};

TEST_F(OnAFullDisk, AnExportLeavesTheOldFile) {
  for (const auto& [item, name] :
       {std::pair("menu.export_wif", "a.wif"), std::pair("menu.export_draft", "draft.pdf"),
        std::pair("menu.export_draft", "draft.png"), std::pair("menu.export_bitmap", "weave.png"),
        std::pair("menu.export_bitmap", "weave.tif"), std::pair("menu.export_bitmap", "weave.bmp")}) {
    SCOPED_TRACE(name);
    const std::string file = oldFile(name);
    const std::map<std::string, std::string> before = filesIn(out);
    const auto replace = [&, item = item] { writeBy({"menu.file", "menu.export", item}, file); };
    {
      const FullDisk full(FullDisk::kFewerThanAnyFile);
      replace();
      untilSaid("message", "File too large");
    }
    EXPECT_THAT(editor.fact("message"), HasSubstr(file));
    editor.answer();
    EXPECT_EQ(filesIn(out), before);
    replace();
    untilSaid("message", "Written");
    editor.answer();
    EXPECT_NE(test::bytesOf(file), kOld);
  }
}

/// It is rendered before it is written: of hardly any cloth, which is soon done, and not anew once there is room.
TEST(OnAFullDiskASheet, LeavesTheOldFile) {
  Fabric open = smallCloth("Blue");
  open.ends_per_cm = open.picks_per_cm = 0.2;
  open.yarns[0].fibresPerPly = 1;
  EditorBesideAFolder at(open);
  using Way = std::vector<std::string>;
  for (const auto& [way, name] : {std::pair(Way{"menu.file", "menu.sheet"}, "sheet.pdf"),
                                  std::pair(Way{"menu.edit", "menu.colourways", "colourways.print"}, "rust.png")}) {
    SCOPED_TRACE(name);
    const std::string file = at.oldFile(name);
    const std::map<std::string, std::string> before = filesIn(at.out);
    {
      const FullDisk full(FullDisk::kFewerThanAnyFile);
      at.writeBy(way, file);
      at.untilSaid("message", file + ": cannot be written: File too large");
    }
    at.editor.answer();
    EXPECT_EQ(filesIn(at.out), before);
  }
}

TEST_F(OnAFullDisk, ASnapshotLeavesTheOldFile) {
  for (const char* name : {"seen.png", "seen.exr"}) {
    const std::string file = oldFile(name);
    editor.key("ctrl+p");
    editor.enter("snapshot.file", file);
    leavesTheOldFile("snapshot", file);
    replaces("snapshot", file);
  }
}

TEST_F(OnAFullDisk, ATileLeavesTheOldFiles) {
  editor.key("ctrl+e");
  editor.enter("tile.size", "32");
  editor.enter("tile.samples", "1");
  editor.enter("tile.file", (out / "tile.json").string());
  oldFile("tile.json");
  const std::string file = oldFile("tile.exr");
  leavesTheOldFile("tile", file);
  replaces("tile", file);
}

/// Made a second time, it would take twice as long.
TEST_F(OnAFullDisk, AHandOverLeavesTheOldFiles) {
  clickAll({"menu.file", "menu.handover"});
  editor.until("its size is known", [&] { return editor.fact("handover.size_mm").ends_with("mm"); });
  editor.click("handover.twist/Off");
  for (const auto& [field, number] : {std::pair("size", "32"), std::pair("samples", "1"), std::pair("measure", "2")})
    editor.enter(std::string("handover.") + field, number);
  editor.enter("handover.folder", out.string());
  fs::create_directory(out / "textures");
  oldFile("Blue.handover.json");
  leavesTheOldFile("handover", oldFile("textures/Blue_BASE.png"));
}

/// Nothing is rendered for it. A file in the place of a folder is in the way of root, too.
TEST_F(OnAFullDisk, APlaceThatTakesNoFileIsNamed) {
  const std::string noFolder = oldFile("file");
  const auto isRefused = [&](const std::vector<std::string>& way, const std::string& name) {
    clickAll(way);
    editor.nameFile(noFolder + name);
    untilSaid("message", noFolder + name);
    editor.answer();
  };
  isRefused({"menu.file", "menu.export", "menu.export_wif"}, "/a.wif");
  isRefused({"menu.file", "menu.export", "menu.export_draft"}, "/a.pdf");
  isRefused({"menu.file", "menu.export", "menu.export_bitmap"}, "/a.png");
  isRefused({"menu.file", "menu.sheet"}, "/sheet.pdf");
  isRefused({"menu.edit", "menu.colourways", "colourways.print"}, "/colourways.pdf");
  const auto isRefusedBy = [&](const std::string& dialog, const std::string& field, const std::string& name) {
    editor.enter(dialog + "." + field, noFolder + name);
    editor.click(dialog + ".start");
    untilSaid(dialog + ".outcome", noFolder + name);
    close(dialog);
  };
  editor.key("ctrl+p");
  isRefusedBy("snapshot", "file", "/seen.png");
  editor.key("ctrl+e");
  isRefusedBy("tile", "file", "/tile.json");
  clickAll({"menu.file", "menu.handover"});
  isRefusedBy("handover", "folder", "/handover");
  EXPECT_EQ(filesIn(out), (std::map<std::string, std::string>{{"file", kOld}}));
}

/// There is no dialog that would say so: the status bar does, in the place of its figures where the window is narrow.
TEST(OnAFullDiskWithoutADialog, AViewThatWillNotLastIsToldOf) {
  HeadlessEditor editor({960, 600, 1});
  editor.start(smallCloth("Blue"));
  editor.key("j");
  editor.until("the lamp takes room from what is said", [&] { return editor.shows("status.lamp"); });
  // A view of a picture that is not at rest is kept anew when that is clearer, and then it lasts.
  editor.untilPictured();
  editor.until("the picture is at rest", [&] { return editor.number("shown_samples") == 1; });
  {
    const FullDisk full(FullDisk::kFewerThanAnyFile);
    editor.key("k");
    editor.until("it is told of",
                 [&] { return editor.fact("status.warning").starts_with("The view that was kept will not last"); });
  }
  editor.move(editor.centre("status.warning"));
  editor.until("why is read where the mouse rests",
               [&] { return editor.fact("tooltip").find("File too large") != std::string::npos; });
  EXPECT_LT(editor.rect("status.warning").x1, editor.rect("status.lamp").x0);
  EXPECT_TRUE(editor.shows("snapshot.item_0")) << "as long as the editor runs";
  EXPECT_THAT(filesIn(viewFolder()), testing::IsEmpty());
  editor.key("k");
  editor.until("both last now", [&] { return filesIn(viewFolder()).size() == 2; });
  editor.until("all is well", [&] { return !editor.fact("status.warning").starts_with("The view"); });
  EXPECT_TRUE(editor.shows("snapshot.item_1"));
}

class PresetsOnAFullDisk : public OnAFullDisk {
 protected:
  static std::string card(const std::string& name) { return "presets.card/" + name; }
  void write(const std::string& field, const std::string& text) {
    editor.click(card("Blue"));
    editor.click("presets." + field);
    editor.key("ctrl+a");
    editor.type(text);
  }
  /// With one that is kept, and has tags.
  void openWithOne() {
    editor.key("ctrl+b");
    editor.click("presets.keep");
    editor.until("it is kept", [&] { return editor.shows(card("Blue")); });
    write("tags", "winter, client A");
    editor.click("presets.tag");
    editor.until("it is tagged", [] { return fs::exists(presetFolder() / "tags"); });
  }
};

TEST_F(PresetsOnAFullDisk, AllStayAsTheyWere) {
  openWithOne();
  const std::map<std::string, std::string> before = filesIn(presetFolder());
  {
    const FullDisk full(FullDisk::kFewerThanAnyFile);
    editor.click("presets.keep");
    untilSaid("presets.problem", "Blue 2.json: cannot be written: File too large");
    write("name", "Bluish");
    editor.click("presets.rename");
    untilSaid("presets.problem", "Bluish.json: cannot be written: File too large");
    editor.click(card("Blue"));
    editor.click("presets.duplicate");
    untilSaid("presets.problem", "Blue 2.json: cannot be written: File too large");
    write("tags", "summer");
    editor.click("presets.tag");
    untilSaid("presets.problem", "tags: cannot be written: File too large");
    close("presets");
    EXPECT_EQ(filesIn(presetFolder()), before);
    clickAll({"menu.file", "menu.save_preset"});
    untilSaid("message", "Blue 2.json: cannot be written: File too large");
    editor.answer();
  }
  EXPECT_EQ(filesIn(presetFolder()), before);
  clickAll({"menu.file", "menu.save_preset"});
  untilSaid("message", "\"Blue 2\" is among the presets now.");
  editor.answer();
}

/// A file goes without room for another; its tags, which would have to be written anew, stay with its name.
TEST_F(PresetsOnAFullDisk, OneThatIsRemovedComesBackWithItsTags) {
  openWithOne();
  const std::map<std::string, std::string> before = filesIn(presetFolder());
  {
    const FullDisk full(FullDisk::kFewerThanAnyFile);
    editor.click(card("Blue"));
    editor.click("presets.remove");
    untilSaid("presets.problem", "tags: cannot be written: File too large");
    editor.until("it is removed", [&] { return !editor.shows(card("Blue")); });
    editor.click("presets.undo");
    editor.until("it is back", [&] { return editor.shows(card("Blue")); });
  }
  fs::remove(presetFolder() / "removed");
  EXPECT_EQ(filesIn(presetFolder()), before);
}

}  // namespace
}  // namespace loomlight
