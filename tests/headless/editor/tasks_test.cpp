/// Tasks that designers sit down to do, each in few actions; the time that the editor takes is nobody's action. Every
/// task ends with the cloth that was asked for, in its file. And what is wrong is not taken: it is said, and what was
/// stays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/export/snapshot.h"
#include "core/fabric/yarn/derived.h"
#include "render/film/image.h"
#include "tests/headless/editor/weaver.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

class DesignersTasks : public testing::Test {
 protected:
  /// How many actions a task takes.
  int actionsOf(const std::function<void()>& task) {
    const int before = editor.actions();
    task();
    return editor.actions() - before;
  }
  void untilNothingIsTyped() {
    editor.until("nothing is typed", [&] { return editor.fact("text_input") == "no"; });
  }
  /// The click that opens the field takes all that is in it, so that the value is typed at once.
  void fillIn(const std::string& field, const std::string& value) {
    editor.click(field);
    editor.type(value);
    editor.key("Return");
  }
  /// In the file browser: where the name is typed listens from the beginning.
  void name(const std::string& file) {
    editor.until("a name is asked for", [&] { return editor.shows("browser.name"); });
    editor.type(file);
    editor.key("Return");
  }
  void open(const std::string& file) {
    editor.key("ctrl+o");
    name(file);
    editor.until("the file is named", [&] { return !editor.shows("browser.name"); });
  }
  /// Of a cloth that has no file yet.
  Fabric savedFirst(const std::string& file) {
    editor.key("ctrl+s");
    name(file);
    editor.until("it is saved", [&] { return editor.fact("file") == file && editor.fact("dirty") == "no"; });
    editor.untilNoDialogIsOpen();
    return readFabric(file);
  }
  void beginAnew() {
    editor.key("ctrl+n");
    editor.until("there is a new cloth", [&] { return editor.fact("file").empty() && editor.fact("dirty") == "no"; });
  }
  /// What is looked at on the page of fibres, by the colour that the cloth should have.
  void dye(const std::string& colour) {
    const auto remark = [&] { return editor.fact("fibre.cloth_colour_remark"); };
    editor.until("the cloth is measured", [&] { return !remark().empty() && !remark().starts_with("Measuring"); });
    fillIn("fibre.colour_code", colour);
    editor.until("the colour is reached", [&] { return remark().starts_with("Reached"); });
    untilNothingIsTyped();
  }

  HeadlessEditor editor{{960, 600, 1}};  // the smallest window: what has room there has room everywhere
};

/// No task seems short because what was done is not counted.
TEST_F(DesignersTasks, AreCountedAsDesignersWouldCount) {
  editor.start(smallTwill());
  EXPECT_EQ(actionsOf([&] { editor.move(editor.centre("viewport")); }), 0);
  EXPECT_EQ(actionsOf([&] { editor.click("tab.cloth"); }), 1);
  EXPECT_EQ(actionsOf([&] { editor.dragWidget("viewport", 40); }), 1);
  EXPECT_EQ(actionsOf([&] {
              for (int clicks = 0; clicks < 3; ++clicks) editor.wheelAt(editor.centre("viewport"), 1);
            }),
            1)
      << "one turn of the wheel";
  EXPECT_EQ(actionsOf([&] { fillIn("cloth.ends_per_cm", "31"); }), 2) << "Enter takes the value";
  EXPECT_EQ(actionsOf([&] {
              editor.click("cloth.ends_per_cm");
              editor.type("30");
              editor.key("Tab");
              editor.type("27");
              editor.key("Return");
            }),
            3)
      << "so does Tab";
  EXPECT_EQ(actionsOf([&] { editor.key("Return"); }), 1) << "Enter that takes no value";
  EXPECT_EQ(actionsOf([&] { editor.key("ctrl+shift+z"); }), 1) << "what is held beside a key is no other";
  EXPECT_EQ(actionsOf([&] { editor.character("]"); }), 1);
}

TEST_F(DesignersTasks, AHoundstoothFromNewTakesAtMostFifteenActions) {
  editor.start(smallTwill());
  Fabric cloth;
  EXPECT_LE(actionsOf([&] {
              beginAnew();
              editor.click("structure/Twill 2/2");
              editor.click("draft.tab_colours");
              fillIn("draft.warp_order", "4A 4B");
              fillIn("draft.weft_order", "4A 4B");
              editor.click("tab.fibre");
              dye("#39353c");
              editor.character("]");
              dye("#9c9482");
              cloth = savedFirst(editor.homeFile("houndstooth.json"));
            }),
            15);
  EXPECT_THAT(rowsOf(cloth.weave), UnorderedElementsAre("#..#", "##..", ".##.", "..##")) << "no 2/2 twill";
  EXPECT_THAT(cloth.warpSequence, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1));
  EXPECT_THAT(cloth.weftSequence, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1));
  const auto dyeOf = [&](size_t yarn) {
    return cloth.fibres.at(static_cast<size_t>(cloth.yarns.at(yarn).fibre)).absorption_per_mm;
  };
  EXPECT_NE(dyeOf(0), dyeOf(1)) << "both yarns are of one colour";
}

TEST_F(DesignersTasks, ASilkSatinOfAWantedColourTakesAtMostTwelveActions) {
  editor.start(smallTwill());
  Fabric cloth;
  EXPECT_LE(actionsOf([&] {
              beginAnew();
              editor.key("ctrl+b");
              fillIn("presets.search", "charm");
              editor.click("presets.card/Charmeuse");
              editor.key("Return");
              editor.untilNoDialogIsOpen();
              editor.click("tab.fibre");
              editor.click("fibre.dyed/Piece");
              dye("#8c4453");
              cloth = savedFirst(editor.homeFile("satin.json"));
            }),
            12);
  ASSERT_FALSE(cloth.fibres.empty());
  for (const Fibre& fibre : cloth.fibres) {
    EXPECT_THAT(fibre.name, HasSubstr("silk"));
    EXPECT_EQ(fibre.absorption_per_mm, cloth.fibres[0].absorption_per_mm) << "the piece has not one dye";
  }
  EXPECT_GE(floats(cloth.weave).warp(), 4) << "no satin";
}

/// Black on white with smooth edges, as programs draw it: a picture of many greys and no point paper.
void drawRing(const std::string& file) {
  constexpr int kSide = 48;
  constexpr double kCentre = kSide / 2.0, kRadius = 12, kHalfWidth = 4;
  Pixels8 picture{kSide, kSide, 3, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double outside = std::abs(std::hypot(x - kCentre, y - kCentre) - kRadius) - kHalfWidth;
      const auto grey = static_cast<uint8_t>(std::lround(255 * std::clamp(outside + 0.5, 0.0, 1.0)));
      picture.bytes.insert(picture.bytes.end(), 3, grey);
    }
  writePng(file, picture);
}

TEST_F(DesignersTasks, APictureIsWovenInAtMostSixActions) {
  const std::string file = editor.homeFile("rings.png");
  drawRing(file);
  editor.startWithoutFile(smallTwill());
  Fabric cloth;
  EXPECT_LE(actionsOf([&] {
              open(file);
              editor.until("the picture is read", [&] { return editor.fact("picture.state") == "ready"; });
              editor.key("Return");
              editor.untilNoDialogIsOpen();
              cloth = savedFirst(editor.homeFile("rings.json"));
            }),
            6);
  ASSERT_GE(cloth.weave.ends(), 16);
  ASSERT_GE(cloth.weave.picks(), 16);
  const Rows rows = rowsOf(cloth.weave);
  const auto warpOver = [](const std::string& row) { return std::count(row.begin(), row.end(), '#'); };
  EXPECT_NE(warpOver(rows[rows.size() / 2]), warpOver(rows[0])) << "there is no ring in the weave";
}

/// A picture of cloth as surroundings: what the program renders is light too.
void renderSmall(const std::string& file) {
  Fabric cloth = smallTwill();
  cloth.render.width = 32;
  cloth.render.height = 16;
  cloth.render.samplesPerPixel = 1;
  ASSERT_TRUE(writeSnapshot(std::make_shared<const Fabric>(cloth), file, Tone{}, SnapshotPrint{}, Task{}));
}

/// The files of a folder whose names end so.
std::vector<std::string> filesEndingIn(const std::filesystem::path& folder, const std::string& ending) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().string().ends_with(ending)) files.push_back(entry.path().string());
  return files;
}

TEST_F(DesignersTasks, AMeshAndSurroundingsOfOnesOwnAndATileTakeAtMostEightActions) {
  const std::string light = editor.homeFile("studio.exr");
  renderSmall(light);
  editor.startWithoutFile(smallTwill());
  EXPECT_LE(actionsOf([&] {
              open(LOOMLIGHT_SAMPLES "/folded_cloth.obj");
              editor.untilNoDialogIsOpen();
              open(light);
              editor.untilNoDialogIsOpen();
              editor.key("ctrl+e");
              editor.until("the tile's size is known", [&] { return editor.fact("tile.size_mm").ends_with("mm"); });
              fillIn("tile.size", "32");  // what is soon rendered
              untilNothingIsTyped();
              editor.key("Return");
              editor.until("the tile is written", [&] { return editor.fact("tile.outcome").starts_with("Written"); });
            }),
            8);
  const std::vector<std::string> tiles = filesEndingIn(editor.home(), "tile.json");
  ASSERT_EQ(tiles.size(), 1u);
  const auto tile = nlohmann::json::parse(test::bytesOf(tiles[0]));
  EXPECT_EQ(std::max(tile["width_px"].get<int>(), tile["height_px"].get<int>()), 32);
  editor.key("Return");
  editor.untilNoDialogIsOpen();
  const std::string scene = editor.homeFile("scene.json");
  savedFirst(scene);
  const auto saved = nlohmann::json::parse(test::bytesOf(scene));
  EXPECT_EQ(saved["drape"]["kind"].get<std::string>(), "mesh");
  EXPECT_THAT(saved["drape"]["file"].get<std::string>(), testing::EndsWith("folded_cloth.obj"));
  EXPECT_EQ(saved["light"]["file"].get<std::string>(), "studio.exr") << "as it lies beside the cloth";
}

class WrongValues : public DesignersTasks {
 protected:
  WrongValues() {
    editor.start(smallTwill());
    before = editor.number("revision");
  }
  void expectUntouched(const std::string& wrong) {
    EXPECT_EQ(editor.number("revision"), before) << wrong << " was taken";
    EXPECT_EQ(editor.fact("dirty"), "no") << wrong << " is an edit";
  }
  uint64_t before = 0;
};

TEST_F(WrongValues, ASettThatIsNoNumberOrBeyondItsRangeIsNotTaken) {
  editor.click("tab.cloth");
  for (const char* value : {"9999", "-3", "many", "1,234"}) {
    fillIn("cloth.ends_per_cm", value);
    untilNothingIsTyped();
    expectUntouched(value);
  }
}

/// Each with its own reason, so that what was said of the one before is not taken for it.
TEST_F(WrongValues, AnOrderOfThreadsThatIsNoneIsRefusedAloud) {
  editor.click("draft.tab_colours");
  for (const auto& [order, problem] :
       {std::pair("6A 4Z", "There is no yarn Z"), std::pair("4A 2(B", "Expected as many ( as )"),
        std::pair("0A", "Expected a number from 1")}) {
    editor.enter("draft.warp_order", order);
    editor.until(std::string(order) + " is refused aloud",
                 [&, said = problem] { return editor.fact("draft.warp_order_problem").starts_with(said); });
    expectUntouched(order);
  }
}

/// Its name is longer than the line in which that is said: of a text that has no room, tests are told all.
TEST_F(WrongValues, AFileThatIsNotThereIsSaidToBeMissing) {
  const std::string missing = editor.homeFile(std::string(200, 'n') + ".json");
  editor.key("ctrl+o");
  name(missing);
  editor.until("it is said that there is none",
               [&] { return editor.fact("shortened.browser.problem") == "There is no " + missing; });
  EXPECT_TRUE(editor.shows("browser.problem"));
  editor.click("browser.cancel");
  editor.untilNoDialogIsOpen();
  expectUntouched(missing);
}

}  // namespace
}  // namespace loomlight
