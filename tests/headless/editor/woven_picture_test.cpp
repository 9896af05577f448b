/// Pictures that are woven: their colours chosen and merged, the cloth of them shown beforehand, into the whole weave
/// or a selection.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "render/film/image.h"
#include "tests/headless/editor/weaver.h"

namespace loomlight {
namespace {

/// An orange disc within a navy one on white, with a speck of grey.
std::string ringsIn(const std::string& file) {
  Pixels8 picture{96, 64, 3, {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      std::array<uint8_t, 3> colour{255, 255, 255};
      if (std::hypot(x - 40, y - 32) < 22) colour = {0, 0, 128};
      if (std::hypot(x - 48, y - 32) < 8) colour = {255, 165, 0};
      if (std::hypot(x - 90, y - 32) < 2) colour = {128, 128, 128};
      picture.bytes.insert(picture.bytes.end(), colour.begin(), colour.end());
    }
  writePng(file, picture);
  return file;
}

class WovenPicture : public testing::Test {
 protected:
  WovenPicture() { editor.start(smallTwill()); }

  void openPicture() {
    editor.click("menu.weave");
    editor.click("menu.picture");
    editor.nameFile(ringsIn(editor.homeFile("rings.png")));
    editor.until("the dialog shows four colours", [&] { return editor.fact("picture.colours") == "4"; });
  }
  Pixels8 preview() {
    editor.until("the cloth is shown beforehand", [&] { return editor.pictureIn("picture.preview") != nullptr; });
    return *editor.pictureIn("picture.preview");
  }

  HeadlessEditor editor;
  Weaver weaver{editor};
};

TEST_F(WovenPicture, BecomesAJacquard) {
  openPicture();
  editor.enter("picture.colours", "3");
  editor.until("the palette is reduced", [&] { return editor.fact("picture.colours") == "3"; });
  editor.choose("picture.structure_2", "Plain");
  editor.enter("picture.ends", "192");
  editor.click("picture.proportions");
  editor.edits("the picture is woven", [&] { editor.click("picture.weave"); });
  const Fabric fabric = editor.savedAs(editor.homeFile("rings.json"));
  EXPECT_EQ(fabric.weave.ends(), 192);
  EXPECT_EQ(fabric.weave.picks(), 192 * 64 / 96) << "as square a cloth as the picture: ends and picks are as dense";
  const std::string ground = rowsOf(fabric.weave)[0].substr(0, 6);
  EXPECT_TRUE(ground == "#.#.#." || ground == ".#.#.#") << ground;
  EXPECT_EQ(editor.fact("draft.kind"), "jacquard");
}

TEST_F(WovenPicture, ColoursMergeByDraggingOneOnAnother) {
  openPicture();
  ASSERT_TRUE(editor.shows("picture.colour_2")) << "orange, the third from dark to light";
  editor.drag(editor.centre("picture.colour_2"), editor.centre("picture.colour_0"));
  editor.until("orange goes with navy", [&] { return !editor.shows("picture.colour_2"); });
  EXPECT_TRUE(editor.shows("picture.colour_1"));
  editor.choose("picture.structure_0", "Plain");
  editor.edits("the picture is woven", [&] { editor.click("picture.weave"); });
  const Weave weave = editor.savedAs(editor.homeFile("rings.json")).weave;
  ASSERT_EQ(weave.ends(), 96);
  ASSERT_EQ(weave.picks(), 64);
  for (const int end : {22, 24, 46, 50})  // in the navy ring, and in the orange disc
    EXPECT_NE(weave.at(31, end), weave.at(31, end + 1)) << "plain at " << end;
}

TEST_F(WovenPicture, TheClothIsShownInItsYarnsBeforehand) {
  editor.until("the yarns' colours are known", [&] { return editor.fact("yarn_colours") == "known"; });
  openPicture();
  const Pixels8 before = preview();
  std::set<std::array<uint8_t, 3>> colours;
  for (size_t i = 0; i < before.bytes.size(); i += 3)
    colours.insert({before.bytes[i], before.bytes[i + 1], before.bytes[i + 2]});
  EXPECT_EQ(colours.size(), 2u) << "of warp and weft, none of the picture's";
  EXPECT_EQ(colours.count({255, 165, 0}), 0u);
  editor.choose("picture.structure_3", "Warp over");
  editor.until("the ground is the warp alone", [&] {
    const Pixels8* const now = editor.pictureIn("picture.preview");
    return now && now->bytes != before.bytes;
  });
  editor.click("picture.shown/Colours");
  editor.until("the colours are shown", [&] { return editor.pictureIn("picture.preview") == nullptr; });
}

TEST_F(WovenPicture, FillsTheSelectionAndNothingElse) {
  editor.click("draft.tab_structures");
  weaver.takes("Satin 8");
  editor.until("the whole repeat is shown", [&] { return editor.shows("draft.cell_0_0"); });
  const Rows before = weaver.rows();
  weaver.select(1, 2, 4, 6);
  editor.until("selected", [&] { return editor.fact("draft.selection") == "1 2 4 5"; });
  openPicture();
  EXPECT_EQ(editor.fact("picture.selection"), "5 \xC3\x97 4");
  for (int colour = 0; colour < 4; ++colour) editor.choose("picture.structure_" + std::to_string(colour), "Warp over");
  editor.edits("the picture is woven", [&] { editor.click("picture.weave"); });
  Rows expected = before;
  for (size_t row = 3; row <= 6; ++row) expected[row].replace(2, 5, "#####");
  EXPECT_EQ(weaver.rows(), expected);
  EXPECT_EQ(editor.fact("draft.selection"), "1 2 4 5") << "it stays, to be filled with something else";
}

TEST_F(WovenPicture, MayTakeThePlaceOfTheWholeWeaveAllTheSame) {
  weaver.select(0, 0, 1, 1);
  editor.until("selected", [&] { return editor.fact("draft.selection") == "0 0 2 2"; });
  openPicture();
  EXPECT_FALSE(editor.shows("picture.ends"));
  editor.click("picture.into/Repeat");
  editor.edits("the picture is woven", [&] { editor.click("picture.weave"); });
  EXPECT_EQ(editor.savedAs(editor.homeFile("rings.json")).weave.ends(), 96);
}

}  // namespace
}  // namespace loomlight
