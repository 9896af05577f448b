/// Files and folders that nobody may write: the editor says so of each in one message, and what was there is there as
/// it was. Of places in which not even root may make a file, that of a cloth is tried in disk_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

#include "app/editor/model/user_folders.h"
#include "tests/headless/editor/written_beside.h"
#include "tests/support/write_protected.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

using test::WriteProtected;

constexpr const char* kFileIsProtected = ": cannot be written: Permission denied";
constexpr const char* kFolderIsProtected = ": cannot be written into its folder: Permission denied";

/// Acts while that place is protected; the editor's folder is as it was.
template <class Act>
void expectUntouched(EditorBesideAFolder& at, const fs::path& place, const Act& act) {
  const std::map<std::string, std::string> before = filesIn(at.out);
  const WriteProtected kept(place);
  act();
  EXPECT_EQ(filesIn(at.out), before);
}

TEST(WriteProtectedPlaces, TakeNothingThatAMenuWrites) {
  using Way = std::vector<std::string>;
  test::humbly([] {
    EditorBesideAFolder at;
    for (const auto& [way, name] : {std::pair(Way{"menu.file", "menu.save_as"}, "cloth.json"),
                                    std::pair(Way{"menu.file", "menu.export", "menu.export_wif"}, "a.wif"),
                                    std::pair(Way{"menu.file", "menu.export", "menu.export_draft"}, "draft.pdf"),
                                    std::pair(Way{"menu.file", "menu.export", "menu.export_bitmap"}, "weave.png"),
                                    std::pair(Way{"menu.file", "menu.sheet"}, "sheet.pdf"),
                                    std::pair(Way{"menu.edit", "menu.colourways", "colourways.print"}, "rust.png")}) {
      SCOPED_TRACE(name);
      const std::string old = at.oldFile(name), other = (at.out / ("new_" + std::string(name))).string();
      expectUntouched(at, old, [&, way = way] {
        at.writeBy(way, old);
        at.untilSaid("message", old + kFileIsProtected);
        at.editor.answer();
      });
      expectUntouched(at, at.out, [&, way = way] {
        at.clickAll(way);
        at.editor.nameFile(other);
        at.untilSaid("message", other + kFolderIsProtected);
        at.editor.answer();
      });
    }
  });
}

TEST(WriteProtectedPlaces, TakeNothingThatADialogRenders) {
  test::humbly([] {
    EditorBesideAFolder at;
    const auto isRefused = [&](const std::string& dialog, const std::string& place, const std::string& said) {
      expectUntouched(at, place, [&] {
        at.editor.click(dialog + ".start");
        at.untilSaid(dialog + ".outcome", said);
      });
    };
    const std::string seen = at.oldFile("seen.png"), tile = at.oldFile("tile.exr"), sidecar = (at.out / "tile.json"),
                      handover = at.oldFile("Blue.handover.json");
    at.editor.key("ctrl+p");
    at.editor.enter("snapshot.file", seen);
    isRefused("snapshot", seen, seen + kFileIsProtected);
    at.editor.enter("snapshot.file", (at.out / "new.png").string());
    isRefused("snapshot", at.out, (at.out / "new.png").string() + kFolderIsProtected);
    at.close("snapshot");
    at.editor.key("ctrl+e");
    at.editor.enter("tile.size", "32");
    at.editor.enter("tile.samples", "1");
    at.editor.enter("tile.file", sidecar);
    isRefused("tile", tile, tile + kFileIsProtected);
    isRefused("tile", at.out, sidecar + kFolderIsProtected);
    at.close("tile");
    at.clickAll({"menu.file", "menu.handover"});
    at.editor.enter("handover.folder", at.out.string());
    isRefused("handover", handover, handover + kFileIsProtected);
    isRefused("handover", at.out, kFolderIsProtected);
    at.close("handover");
  });
}

TEST(WriteProtectedPlaces, TakeNothingThatIsKept) {
  test::humbly([] {
    EditorBesideAFolder at;
    fs::create_directories(viewFolder());
    fs::create_directories(presetFolder());
    fs::create_directories(stateFolder());
    const WriteProtected views(viewFolder()), presets(presetFolder()), state(stateFolder());
    at.clickAll({"menu.file", "menu.save_preset"});
    at.untilSaid("message", "Permission denied");
    at.editor.answer();
    at.editor.key("k");
    at.untilSaid("status.warning", "The view that was kept will not last");
    at.editor.move(at.editor.centre("status.warning"));
    at.untilSaid("tooltip", "Permission denied");
    at.editor.turnACrossing();
    at.untilSaid("autosave_problem", "Permission denied");
    for (const fs::path& folder : {viewFolder(), presetFolder()}) EXPECT_THAT(filesIn(folder), testing::IsEmpty());
  });
}

/// Of a cloth that was opened from there.
TEST(WriteProtectedPlaces, KeepTheClothThatTheyHave) {
  test::humbly([] {
    HeadlessEditor editor({960, 600, 1});
    const std::string file = editor.start(smallCloth("Blue")), before = test::bytesOf(file);
    const WriteProtected kept(file);
    editor.turnACrossing();
    editor.key("ctrl+s");
    editor.until("it is said",
                 [&] { return editor.fact("message").find(file + kFileIsProtected) != std::string::npos; });
    editor.answer();
    EXPECT_EQ(editor.fact("dirty"), "yes") << "work that is not on the disk counts as saved";
    EXPECT_EQ(test::bytesOf(file), before);
  });
}

}  // namespace
}  // namespace loomlight
