/// WIF drafts, weave bitmaps and fabrics from before pressing: opened by dialog and by name, their sizes chosen, their
/// warnings shown, exported.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/fabric/json/fabric_json.h"
#include "render/film/image.h"
#include "tests/headless/editor/weaver.h"

namespace loomlight {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kRosepath = R"([WIF]
Version=1.1
Date=April 20, 1997
Developers=wif@mhsoft.com
Source Program=Handmade
[CONTENTS]
WEAVING=true
WARP=true
WEFT=true
TEXT=true
TIEUP=true
THREADING=true
TREADLING=true
[TEXT]
Title=Rosepath
[WEAVING]
Shafts=four
Treadles=4
Rising Shed=true
[WARP]
Threads=6
Units=Centimeters
Spacing=0.1
Thickness=0.1
[WEFT]
Threads=4
Units=Centimeters
Spacing=0.125
Thickness=0.1
[TIEUP]
1=1,2
2=2,3
3=3,4
4=1,4
[THREADING]
1=1
2=2
3=3
4=4
5=3
6=2
[TREADLING]
1=1
2=2
3=3
4=4
)";

const std::vector<std::vector<int>> kThreading = {{1}, {2}, {3}, {4}, {3}, {2}};

constexpr size_t kMost_bytes = 10'000'000;

class WeavingFiles : public testing::Test {
 protected:
  WeavingFiles() { editor.start(smallTwill()); }

  std::string write(const std::string& name, const std::string& text) {
    const std::string file = editor.homeFile(name);
    std::ofstream(file) << text;
    return file;
  }
  void open(const std::string& file) {
    editor.key("ctrl+o");
    editor.nameFile(file);
  }
  /// Rosepath, with the sizes that its file gives.
  void openRosepath() {
    open(write("rosepath.wif", kRosepath));
    editor.until("the WIF draft is opened", [&] { return editor.fact("name") == "Rosepath"; });
    EXPECT_GE(editor.number("wif.warnings"), 1u) << "nothing is said of Shafts=four";
    editor.click("wif.close");
    editor.untilNoDialogIsOpen();
  }
  /// File > Export > item, to that file.
  std::string exportTo(const std::string& item, const std::string& name) {
    editor.click("menu.file");
    editor.click("menu.export");
    editor.click(item);
    editor.nameFile(editor.homeFile(name));
    editor.answer();
    return editor.homeFile(name);
  }

  HeadlessEditor editor;
};

TEST_F(WeavingFiles, ADraftIsOpenedWithItsSizes) {
  openRosepath();
  const Fabric fabric = editor.savedAs(editor.homeFile("rosepath.json"));
  EXPECT_EQ(fabric.ends_per_cm, 10);
  EXPECT_EQ(fabric.picks_per_cm, 8);
  EXPECT_EQ(fabric.draft.value().threading, kThreading);
  EXPECT_EQ(fabric.drape.width_mm, 4) << "the drape is the designer's own";
}

TEST_F(WeavingFiles, AFabricFromBeforePressingIsToldOf) {
  std::string text = fabricToJson(smallTwill());
  const size_t press = text.find("\"press\"");
  text.erase(press, text.find('\n', press) + 1 - press);
  const std::string file = write("old.json", text);
  const auto isToldOf = [&] {
    editor.until("it is told of",
                 [&] { return editor.fact("message").find("older than the pressing of yarns") != std::string::npos; });
    editor.answer();
    editor.untilNoDialogIsOpen();
  };
  open(file);
  isToldOf();
  editor.leave();
  editor.startOn(file);
  isToldOf();
}

/// Where it is said that the file's sizes are used, they can be refused.
TEST_F(WeavingFiles, TheSizesOfADraftCanBeRefused) {
  open(write("rosepath.wif", kRosepath));
  editor.edits("the designer's own are kept", [&] { editor.click("wif.sizes/Keep mine"); });
  editor.click("wif.close");
  const Fabric fabric = editor.savedAs(editor.homeFile("rosepath.json"));
  EXPECT_EQ(fabric.ends_per_cm, smallTwill().ends_per_cm);
  EXPECT_EQ(fabric.picks_per_cm, smallTwill().picks_per_cm);
}

/// A draft that names 4 of 40 picks: those it names are left where one asks for it, and all come back.
TEST_F(WeavingFiles, PicksThatAreOnlyCountedCanBeCutOff) {
  std::string text = kRosepath;
  text.replace(text.find("Threads=4"), 9, "Threads=40");
  open(write("rosepath.wif", text));
  editor.edits("the named are left", [&] { editor.click("wif.threads/Named only"); });
  editor.edits("all are back", [&] { editor.click("wif.threads/All"); });
  editor.edits("the named are left", [&] { editor.click("wif.threads/Named only"); });
  editor.click("wif.close");
  const Fabric fabric = editor.savedAs(editor.homeFile("rosepath.json"));
  EXPECT_EQ(fabric.weave.picks(), 4);
  EXPECT_EQ(fabric.picks_per_cm, 8) << "with the file's sizes as before";
  EXPECT_EQ(fabric.draft.value().threading, kThreading);
}

/// The list is filtered and gone through by keys; a file is seen before it is opened; Esc leaves at once.
TEST_F(WeavingFiles, ADraftIsSeenBeforeItIsOpened) {
  write("rosepath.wif", kRosepath);
  open(editor.home().string());
  editor.click("browser.filter");
  editor.type("PATH.WIF");
  editor.click("browser.name");
  editor.key("Down");
  editor.until("the draft is seen", [&] { return editor.fact("browser.preview") == "picture"; });
  EXPECT_THAT(editor.fact("browser.about"), HasSubstr("6 ends, 4 picks, 4 shafts"));
  editor.key("Escape");
  editor.untilNoDialogIsOpen();
}

TEST_F(WeavingFiles, ADraftIsExported) {
  openRosepath();
  const std::string text = readFile(exportTo("menu.export_wif", "out.wif"), kMost_bytes);
  for (const char* line : {"\nShafts=4\r\n", "\n5=3\r\n", "\nTitle=Rosepath\r\n"}) EXPECT_THAT(text, HasSubstr(line));
  EXPECT_THAT(readFile(exportTo("menu.export_draft", "draft.pdf"), kMost_bytes), StartsWith("%PDF-"));
}

/// Two colours are point paper, a crossing for each pixel.
TEST_F(WeavingFiles, ABitmapGoesOutAndComesBack) {
  openRosepath();
  const std::string file = exportTo("menu.export_bitmap", "weave.png");
  const PictureExtent extent = readPngExtent(file);
  EXPECT_EQ(extent.width, 6);
  EXPECT_EQ(extent.height, 4);
  editor.click("draft.tab_structures");
  editor.edits("another weave", [&] { editor.click("structure/Plain"); });
  open(file);
  editor.until("two colours are found", [&] { return editor.fact("picture.colours") == "2"; });
  editor.edits("it is woven", [&] { editor.click("picture.weave"); });
  editor.untilNoDialogIsOpen();
  EXPECT_EQ(editor.savedAs(editor.homeFile("again.json")).draft.value().threading, kThreading);
}

TEST_F(WeavingFiles, ABitmapForLoomsIsExported) {
  openRosepath();
  EXPECT_THAT(readFile(exportTo("menu.export_bitmap", "weave.tif"), kMost_bytes), StartsWith("II*"));
  EXPECT_THAT(readFile(exportTo("menu.export_bitmap", "weave.bmp"), kMost_bytes), StartsWith("BM"));
}

TEST_F(WeavingFiles, ATileIsExported) {
  editor.click("menu.file");
  editor.click("menu.export");
  editor.click("menu.export_tile");
  editor.enter("tile.size", "32");
  editor.enter("tile.samples", "1");
  const std::string file = editor.homeFile("tile.json");
  editor.click("tile.browse");
  editor.nameFile(file);
  editor.click("tile.start");
  editor.until("the tile is written", [&] { return editor.fact("tile.outcome").starts_with("Written"); });
  editor.click("tile.close");
  editor.untilNoDialogIsOpen();
  const auto tile = nlohmann::json::parse(readFile(file, kMost_bytes));
  EXPECT_EQ(std::max(tile["width_px"].get<int>(), tile["height_px"].get<int>()), 32);
  EXPECT_TRUE(std::filesystem::exists(editor.home() / tile["maps"]["normal"]["file"].get<std::string>()));
}

TEST_F(WeavingFiles, AFileThatIsNoneLeavesTheCloth) {
  const Rows before = rowsOf(smallTwill().weave);
  open(write("story.wif", "You are in a maze of twisty little passages.\n"));
  editor.answer();
  EXPECT_EQ(editor.fact("name"), "Blue cloth");
  EXPECT_EQ(rowsOf(editor.saved().weave), before);
}

}  // namespace
}  // namespace loomlight
