/// Yarn and fibre as spinners and mills speak of them: counts typed in their systems, twist, diameter, a blend, and
/// what follows for the cloth.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/finish.h"
#include "tests/headless/editor/headless_editor.h"

namespace loomlight {
namespace {

using testing::EndsWith;
using testing::StartsWith;

constexpr double kNe_tex = 590.5;      ///< tex times Ne
constexpr double kPerInch = 1 / 2.54;  ///< per cm, of one to the inch

/// The reference cloth of the trade: Ne 30/1, 76 x 68 to the inch.
Fabric printCloth() {
  Fabric fabric;
  fabric.name = "Print cloth";
  fabric.ends_per_cm = 76 * kPerInch;
  fabric.picks_per_cm = 68 * kPerInch;
  fabric.yarns[0].name = "ring-spun";
  fabric.yarns[0].count_tex = kNe_tex / 30;
  fabric.yarns[0].plyTwist_per_m = 860;
  fabric.drape.width_mm = fabric.drape.height_mm = 5;
  fabric.light.kind = LightKind::dome;
  fabric.camera.distance_mm = 70;  // hardly any of the picture, so that tracing it takes no time
  fabric.camera.elevation_deg = 75;
  fabric.render.resolution = 1;
  return fabric;
}

class YarnPages : public testing::Test {
 protected:
  YarnPages() { editor.start(printCloth()); }

  void types(const std::string& field, const std::string& text) {
    editor.edits(text + " is taken by " + field, [&] { editor.enter(field, text); });
  }
  Yarn yarn() { return editor.saved().yarns[0]; }
  /// The number that a fact begins with.
  double measured(const std::string& name) { return std::stod(editor.fact(name)); }

  HeadlessEditor editor{{1280, 900, 1}};
};

TEST(TallYarnPage, HairinessIsSetAsTestersMeasureIt) {
  HeadlessEditor editor{{1280, 1400, 1}};  // all rows are in sight
  Fabric cloth = printCloth();
  cloth.yarns[0].hairiness_per_mm = 4;
  editor.start(cloth);
  editor.edits("a hairiness", [&] { editor.enter("yarn.hairiness_h", "5"); });
  const Yarn hairy = editor.saved().yarns[0];
  EXPECT_NEAR(hairinessH(hairy, Fibre{}), 5, 0.01);
  editor.until("it is shown", [&] { return !editor.fact("yarn.mean_hair").empty(); });
  EXPECT_NEAR(std::stod(editor.fact("yarn.mean_hair")), 5 / hairy.hairiness_per_mm, 0.01);
  editor.edits("wrapper fibres", [&] { editor.enter("yarn.wrappers_per_cm", "3"); });
  EXPECT_EQ(editor.saved().yarns[0].wrappers_per_cm, 3);
}

TEST(TallClothPage, AFinishIsSwitchedOn) {
  HeadlessEditor editor{{1280, 1400, 1}};
  editor.start(printCloth());
  editor.click("tab.cloth");
  for (bool Fabric::* finish : {&Fabric::singed, &Fabric::brushed, &Fabric::mercerised}) {
    const std::string row = std::string("cloth.") + fieldInfo(finish).key;
    editor.edits(row, [&] { editor.click(row + "/On"); });
    EXPECT_TRUE(editor.saved().*finish) << row;
  }
  editor.edits("milling", [&] { editor.enter("cloth.milling", "0.6"); });
  EXPECT_EQ(editor.saved().milling, 0.6);
}

TEST_F(YarnPages, WhatFollowsForTheCloth) {
  editor.click("tab.cloth");
  editor.until("cover is shown", [&] { return editor.fact("cloth.cover") == "20.1"; });
  EXPECT_EQ(editor.fact("cloth.per_inch"), "76 \u00d7 68");
  editor.until("mass is measured", [&] { return editor.fact("cloth.mass").ends_with("g/m\u00b2"); });
  const double warp = 76 * kPerInch * (1 + measured("cloth.crimp_warp") / 100);
  const double weft = 68 * kPerInch * (1 + measured("cloth.crimp_weft") / 100);
  EXPECT_NEAR(measured("cloth.mass"), 0.1 * kNe_tex / 30 * (warp + weft), 1);  // what is shown is rounded to grams
  // A plain weave shows as much warp as weft.
  editor.until("the weave is counted", [&] { return editor.fact("cloth.balance") == "50 %"; });
  EXPECT_THAT(editor.fact("cloth.warp_float"), StartsWith("1 "));
}

TEST_F(YarnPages, APieceIsReckoned) {
  editor.click("tab.cloth");
  const ImVec2 page = editor.centre("cloth.ends_per_cm");
  const auto inSight = [&](const char* row) {
    return editor.shows(row) && editor.rect(row).y1 < editor.screen().y - 110;
  };
  for (int turns = 0; turns < 40 && !(inSight("cloth.need_warp") && inSight("cloth.piece_length")); ++turns)
    editor.wheelAt(page, -1);
  editor.until("yarn is reckoned", [&] { return !editor.fact("cloth.need_warp").empty(); });
  const std::string before = editor.fact("cloth.need_warp");
  editor.enter("cloth.piece_length", "100");
  editor.until("a longer piece takes more yarn", [&] { return editor.fact("cloth.need_warp") != before; });
  const double straight_km = 0.1 * 150 * 76 * kPerInch;
  EXPECT_GT(measured("cloth.need_warp"), 0.99 * straight_km);
  EXPECT_LT(measured("cloth.need_warp"), 1.3 * straight_km);
  EXPECT_EQ(editor.fact("dirty"), "no") << "reckoning edits nothing";
}

TEST_F(YarnPages, FoldedAndCabledCounts) {
  types("yarn.count_tex", "30/2 Ne");
  EXPECT_EQ(yarn().plies, 2);
  EXPECT_NEAR(yarn().count_tex, 2 * kNe_tex / 30, 1e-6);
  types("yarn.count_tex", "30/2/3 Ne");
  types("yarn.cable_twist_per_m", "365 t/m");
  const Yarn cable = yarn();
  EXPECT_EQ(cable.plies, 2);
  EXPECT_EQ(cable.cords, 3);
  EXPECT_EQ(cable.cableTwist_per_m, 365);
  EXPECT_NEAR(cable.count_tex, 6 * kNe_tex / 30, 1e-6);
  editor.untilPictured();
  types("yarn.count_tex", "30/2 Ne");
  EXPECT_EQ(yarn().cords, 1);
}

/// Rows that an edit takes away make the page shorter; at its end, too, what is edited stays under the mouse.
TEST_F(YarnPages, WhatIsEditedStaysWhereItIs) {
  types("yarn.count_tex", "30/2/3 Ne");
  const ImVec2 page = editor.centre("yarn.count_tex");
  const auto scroll = [&](float clicks) {
    for (int turns = 0; turns < 30; ++turns) editor.wheelAt(page, clicks);
  };
  const HeadlessEditor::Rect first = editor.rect("yarn.cords");
  scroll(-1);
  const HeadlessEditor::Rect last = editor.rect("yarn.cords");
  ASSERT_LT(last.y0, first.y0) << "the page has room for all";
  types("yarn.cords", "1");
  editor.until("the twist of a cable goes", [&] { return !editor.shows("yarn.cable_twist_per_m"); });
  for (int i = 0; i < 5; ++i) editor.frame();
  EXPECT_EQ(editor.rect("yarn.cords"), last);
  scroll(1);
  scroll(-1);
  EXPECT_GT(editor.rect("yarn.cords").y0, last.y0) << "the room of rows that went is kept for ever";
}

TEST_F(YarnPages, MetricCountTwistMultiplierAndDiameter) {
  types("yarn.count_tex", "30/2 Ne");
  editor.choose("yarn.count_system", "Nm (km per kg)");
  types("yarn.count_tex", "60");
  EXPECT_NEAR(yarn().count_tex, 2 * 1000.0 / 60, 1e-6) << "60 is 60/2 Nm";
  types("yarn.ply_twist_per_m", "4 TM");
  EXPECT_NEAR(yarn().plyTwist_per_m, 957 * 4 / std::sqrt(1000.0 / 60), 1);  // 957: turns/m and tex of TM 1, rounded
  types("yarn.diameter_mm", "0.3");
  EXPECT_NEAR(yarn().packing, yarn().count_tex / (1.52 * std::pow(0.3 / 0.03568, 2)), 0.005);
}

TEST_F(YarnPages, FilamentsGiveTheFibreItsFineness) {
  types("yarn.count_tex", "167 dtex f48");
  const Fabric fabric = editor.saved();
  EXPECT_EQ(fabric.yarns[0].count_tex, 16.7);
  EXPECT_EQ(fabric.yarns[0].plies, 1);
  EXPECT_NEAR(fabric.fibres[0].radius_um, std::sqrt(1e3 * 16.7 / 48 / (std::numbers::pi * 1.52)), 0.01);
}

TEST_F(YarnPages, ABlend) {
  editor.edits("a second fibre", [&] { editor.choose("yarn.blend_fibre", "A new fibre"); });
  types("yarn.blend_share", "30");
  editor.click("tab.fibre");
  editor.click("fibre.of_blend/Second");
  editor.edits("wool", [&] { editor.choose("fibre.preset", "wool"); });
  const Fabric fabric = editor.saved();
  EXPECT_EQ(fabric.yarns[0].blendFibre, 1);
  EXPECT_NEAR(fabric.yarns[0].blendShare.value(), 0.3, 1e-9);
  ASSERT_EQ(fabric.fibres.size(), 2u);
  EXPECT_EQ(fabric.fibres[0].scaleTilt_deg, 0);
  EXPECT_EQ(fabric.fibres[1].scaleTilt_deg, 2.5);
  editor.untilPictured();
  EXPECT_EQ(editor.fact("error"), "");
}

TEST_F(YarnPages, AYarnWithoutANameFollowsItsColourAndCount) {
  editor.click("yarn.name");
  editor.key("ctrl+a");
  editor.edits("its name is taken away", [&] { editor.key("Delete"); });
  editor.key("Return");
  editor.until("it goes by both", [&] { return editor.fact("yarn.called").ends_with(" 19.7 tex"); });
  types("yarn.count_tex", "40 tex");
  editor.until("it follows its count", [&] { return editor.fact("yarn.called").ends_with(" 40 tex"); });
  editor.click("tab.fibre");
  editor.edits("a dye", [&] { editor.enter("fibre.colour_code", "#2a4a9c"); });
  editor.click("tab.yarn");
  // In the middle of the blues, so that it is one whatever the cloth is like.
  editor.until("it follows its colour", [&] { return editor.fact("yarn.called").ends_with("blue 40 tex"); });
  types("yarn.name", "Aunt Mary's");
  EXPECT_EQ(editor.fact("yarn.called"), "Aunt Mary's");
}

TEST_F(YarnPages, ANewClothKeepsNothingOfWhatAnotherWasCalled) {
  editor.edits("what is said of it", [&] {
    editor.click("tab.cloth");
    editor.enter("cloth.description", "For curtains.");
  });
  editor.saved();
  editor.key("ctrl+n");
  editor.until("it is new", [&] { return editor.fact("name") == "Untitled"; });
  const Fabric fresh = editor.savedAs(editor.homeFile("fresh.json"));
  EXPECT_EQ(fresh.description, "");
  EXPECT_TRUE(fresh.colourways.empty());
  for (const Yarn& yarn : fresh.yarns) EXPECT_EQ(yarn.name, "");
  for (const Fibre& fibre : fresh.fibres) EXPECT_EQ(fibre.name.find(','), std::string::npos) << fibre.name;
}

TEST_F(YarnPages, AYarnOfTheTrade) {
  editor.edits("a second fibre", [&] { editor.choose("yarn.blend_fibre", "A new fibre"); });
  editor.saved();
  editor.edits("silk", [&] { editor.choose("yarn.preset", "Silk 20/22 den"); });
  const Yarn silk = yarn();
  EXPECT_NEAR(silk.count_tex, 21.0 / 9, 0.01);
  EXPECT_FALSE(silk.blendFibre);
  EXPECT_EQ(silk.name, "ring-spun") << "the yarn's name is the designer's";
  editor.edits("undo takes it back", [&] { editor.key("ctrl+z"); });
  EXPECT_EQ(editor.fact("dirty"), "yes");
}

}  // namespace
}  // namespace loomlight
