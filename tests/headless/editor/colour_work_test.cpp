/// Colour as a designer works with it: the colour that the cloth should have, orders of yarns and stripes by chance,
/// and several colourways of one construction side by side.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/fabric/model/colourways.h"
#include "tests/headless/editor/weaver.h"

namespace loomlight {
namespace {

using testing::ElementsAre;

/// A twill of ecru with every third end navy, each yarn of a fibre of its own.
Fabric ecruAndNavy() {
  Fabric cloth = smallTwill();
  cloth.warpSequence = {0, 0, 1};
  cloth.weftSequence = {0};
  cloth.fibres[0].name = "ecru";
  cloth.fibres[0].absorption_per_mm = Rgb(2, 3, 5);
  cloth.fibres[1].name = "navy";
  cloth.fibres[1].absorption_per_mm = Rgb(60, 40, 12);
  return cloth;
}

/// A sketch, which comes first, has two colours: those of both yarns, or that of one and what is behind it.
bool isRendered(const Pixels8& picture) {
  std::set<std::array<uint8_t, 3>> colours;
  const auto step = static_cast<size_t>(picture.channels);
  for (size_t i = 0; i + 3 <= picture.bytes.size() && colours.size() <= 2; i += step)
    colours.insert({picture.bytes[i], picture.bytes[i + 1], picture.bytes[i + 2]});
  return colours.size() > 2;
}

/// Beside the picture of the cloth, from the start.
TEST(YarnSeenCloseUp, IsRendered) {
  HeadlessEditor editor{{1280, 900, 1}};
  editor.start(ecruAndNavy());
  editor.untilPictured();
  editor.until("the yarn is seen close up", [&] { return editor.fact("yarn.close_up") == "there"; });
  editor.until("it is rendered", [&] {
    const Pixels8* const picture = editor.pictureIn("yarn.close_up");
    return picture && isRendered(*picture);
  });
}

class PickedColour : public testing::Test {
 protected:
  PickedColour() {
    editor.start(ecruAndNavy());
    editor.click("tab.fibre");
    editor.until("the cloth's colour is measured", [&] { return remark().starts_with("Pick"); });
    editor.click("fibre.cloth_colour");
    editor.centre("fibre.cloth_colour/picker");
  }
  std::string remark() const { return editor.fact("fibre.cloth_colour_remark"); }
  /// In the field of saturation and value, which fills the picker's upper left; in parts of the picker's shorter side.
  ImVec2 inPicker(float right, float down) const {
    const HeadlessEditor::Rect picker = editor.rect("fibre.cloth_colour/picker");
    const float side = std::min(picker.x1 - picker.x0, picker.y1 - picker.y0);
    return ImVec2(picker.x0 + right * side, picker.y0 + down * side);
  }

  HeadlessEditor editor{{1280, 900, 1}};
};

/// However often the cloth is dyed while the mouse is down.
TEST_F(PickedColour, ADragDyesOneFibreInOneStep) {
  const std::vector<Fibre> before = ecruAndNavy().fibres;
  editor.move(inPicker(0.3f, 0.35f));
  editor.edits("the press dyes", [&] { editor.press(); });
  editor.edits("the drag dyes", [&] { editor.move(inPicker(0.5f, 0.4f)); });
  editor.release();
  editor.key("Escape");
  editor.until("the colour is reached", [&] { return remark().starts_with("Reached"); });
  const std::vector<Fibre> dyed = editor.saved().fibres;
  ASSERT_EQ(dyed.size(), before.size());
  EXPECT_NE(dyed[0].absorption_per_mm, before[0].absorption_per_mm) << "the fibre was not dyed";
  EXPECT_EQ(dyed[1], before[1]) << "the other fibre was dyed too";
  editor.edits("one step takes the dye back", [&] { editor.key("ctrl+z"); });
  EXPECT_EQ(editor.fact("dirty"), "yes") << "what was saved has the dye";
  EXPECT_EQ(editor.saved().fibres, before) << "undo left some of the dye";
}

/// No cloth is as white as paper.
TEST_F(PickedColour, ThatCannotBeHadGivesTheNearestAndSaysSo) {
  const Rgb before = ecruAndNavy().fibres[0].absorption_per_mm.primaries;
  // Beyond the corner of white, where a hand lands that makes for it.
  editor.edits("the fibre is dyed", [&] { editor.drag(inPicker(0.125f, 0.125f), inPicker(-0.02f, -0.02f)); });
  editor.until("it is said what cannot be", [&] { return remark().find("nearest") != std::string::npos; });
  editor.key("Escape");
  const Rgb dye = editor.saved().fibres[0].absorption_per_mm.primaries;
  for (int c = 0; c < 3; ++c) EXPECT_LT(dye[c], before[c]) << "a lighter cloth is nearer to white";
}

class OrderTools : public testing::Test {
 protected:
  OrderTools() {
    editor.start(ecruAndNavy());
    editor.click("draft.tab_colours");
  }
  std::vector<int> warpOnceClicked(const std::string& tool) {
    editor.edits(tool + " edits the cloth", [&] { editor.click(tool); });
    return editor.saved().warpSequence;
  }

  HeadlessEditor editor{{1280, 1400, 1}};  // the whole page is in sight
};

TEST_F(OrderTools, MirrorReverseAndWidenAnOrder) {
  EXPECT_THAT(warpOnceClicked("order.mirror"), ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(warpOnceClicked("order.reverse"), ElementsAre(0, 1, 0, 0));
  EXPECT_THAT(warpOnceClicked("order.widen"), ElementsAre(0, 0, 1, 1, 0, 0, 0, 0));
}

TEST_F(OrderTools, DrawStripesOfBothYarnsByChance) {
  editor.click("order.chance");
  const std::vector<int> warp = warpOnceClicked("order.random");
  EXPECT_EQ(warp.size(), 96u);
  EXPECT_THAT(std::set<int>(warp.begin(), warp.end()), ElementsAre(0, 1)) << "no stripes";
}

class ColourwaysAtWork : public testing::Test {
 protected:
  void openOn(const Fabric& cloth) {
    editor.start(cloth);
    editor.click("menu.edit");
    editor.click("menu.colourways");
  }
  void keepPresentColours() {
    editor.click("colourways.keep");
    editor.until("the present colours are kept", [&] { return editor.shows("colourways.card_1"); });
  }
  void copy() {
    editor.click("colourways.copy");
    editor.until("there is another one", [&] { return editor.shows("colourways.card_2"); });
  }
  Fabric savedOnceClosed() {
    editor.click("colourways.close");
    editor.untilNoDialogIsOpen();
    return editor.saved();
  }
  static std::vector<std::string> namesOf(const Fabric& cloth) {
    std::vector<std::string> names;
    for (const Colourway& colourway : cloth.colourways) names.push_back(colourway.name);
    return names;
  }

  HeadlessEditor editor{{960, 600, 1}};  // cards are as large as there is room for, and rendered that large
};

TEST_F(ColourwaysAtWork, AreKeptRenamedCopiedAndRemoved) {
  openOn(ecruAndNavy());
  keepPresentColours();
  editor.click("colourways.name");
  editor.key("ctrl+a");
  editor.type("Night");
  copy();
  editor.click("colourways.card_2");
  editor.click("colourways.remove");
  editor.until("the copy is removed", [&] { return !editor.shows("colourways.card_2"); });
  editor.click("colourways.use");
  const Fabric cloth = savedOnceClosed();
  EXPECT_THAT(namesOf(cloth), ElementsAre("Night"));
  EXPECT_EQ(cloth.fibres, ecruAndNavy().fibres) << "the cloth has these colours already";
}

TEST_F(ColourwaysAtWork, AreRendered) {
  Fabric cloth = ecruAndNavy();
  cloth.camera.distance_mm = 11;  // so that it fills a picture from top to bottom
  cloth.camera.elevation_deg = 75;
  openOn(cloth);
  keepPresentColours();
  copy();
  editor.until("its picture is rendered", [&] {
    const HeadlessEditor::Rect card = editor.rect("colourways.card_1");
    const Pixels8* const picture = editor.pictureIn("colourways.card_1");
    // Behind the dialog there are pictures too, none as wide as a card.
    const bool isOwn = picture && picture->width + 1 >= static_cast<int>(card.x1 - card.x0);
    return isOwn && isRendered(*picture) && spreadOf(*picture).deviation > 0.05;
  });
}

TEST_F(ColourwaysAtWork, DyeTheClothThatUsesOne) {
  Fabric night = ecruAndNavy();
  std::swap(night.fibres[0].absorption_per_mm, night.fibres[1].absorption_per_mm);
  Fabric cloth = ecruAndNavy();
  cloth.colourways = {colourwayOf(night, "Night")};
  openOn(cloth);
  editor.click("colourways.card_1");
  editor.edits("it is used", [&] { editor.click("colourways.use"); });
  const Fabric used = savedOnceClosed();
  EXPECT_EQ(used.fibres[0].absorption_per_mm, night.fibres[0].absorption_per_mm);
  EXPECT_EQ(used.fibres[1].absorption_per_mm, night.fibres[1].absorption_per_mm);
  EXPECT_THAT(namesOf(used), ElementsAre("Night"));
}

}  // namespace
}  // namespace loomlight
