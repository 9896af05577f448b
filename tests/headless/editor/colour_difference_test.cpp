/// Two yarns of a cloth, or one in two colourways, under the lamps of a light booth.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/fabric/model/colourways.h"
#include "tests/headless/editor/weaver.h"

namespace loomlight {
namespace {

using testing::EndsWith;

/// Warp and weft of one spinning: "straw" and "slate" are known in bands, which a ripple parts.
Fabric twoYarns(float ripple) {
  Fabric fabric = smallTwill();
  fabric.yarns[1] = fabric.yarns[0];
  fabric.yarns[0].name = "straw";
  fabric.yarns[1].name = "slate";
  fabric.yarns[0].fibre = 0;
  fabric.yarns[1].fibre = 1;
  fabric.fibres.resize(2, fabric.fibres[0]);
  fabric.fibres[1] = fabric.fibres[0];
  Spectrum flat, rippled;
  flat.fill(8);
  for (size_t j = 0; j < kBands; ++j) rippled[j] = 8 * (1 + ripple * std::sin(static_cast<float>(j)));
  fabric.fibres[0].absorption_per_mm = Absorption(flat);
  fabric.fibres[1].absorption_per_mm = Absorption(rippled);
  return fabric;
}

class ColourDifference : public testing::Test {
 protected:
  void open(const Fabric& fabric) {
    editor.start(fabric);
    editor.click("menu.view");
    editor.click("menu.colour_difference");
    untilJudged();
  }
  void untilJudged() {
    editor.until("it is judged",
                 [&] { return editor.fact("difference.remark").find("known to") != std::string::npos; });
  }
  double number(const std::string& fact) { return std::stod(editor.fact("difference." + fact)); }

  HeadlessEditor editor{{1280, 900, 1}};
};

TEST_F(ColourDifference, AYarnBesideItselfIsTheSame) {
  open(twoYarns(0.9f));
  EXPECT_THAT(editor.fact("difference.D65_cmc"), EndsWith("FAIL"));
  editor.choose("difference.sample", "straw");
  editor.until("it is the same", [&] { return editor.fact("difference.D65_cmc").ends_with("pass"); });
  for (const char* lamp : {"D65", "F11", "A", "LED-B3"}) {
    EXPECT_EQ(number(std::string(lamp) + "_ciede2000"), 0) << lamp;
    EXPECT_EQ(editor.fact(std::string("difference.") + lamp + "_standard"),
              editor.fact(std::string("difference.") + lamp + "_sample"));
  }
  EXPECT_EQ(number("F11_metamerism"), 0);
}

/// What daylight hardly tells apart, a lamp of few lines may: that is told of one that is dyed alike by other dyes, and
/// not of one that is merely darker.
TEST_F(ColourDifference, MetamersAreTold) {
  open(twoYarns(0.9f));
  const double ofOthers = number("F11_metamerism");
  EXPECT_GT(ofOthers, 0.5);
  editor.click("difference.close");
  Fabric darker = twoYarns(0);
  darker.fibres[1].absorption_per_mm = darker.fibres[0].absorption_per_mm;
  for (float& band : *darker.fibres[1].absorption_per_mm.bands) band *= 3;
  editor.start(darker);
  editor.click("menu.view");
  editor.click("menu.colour_difference");
  untilJudged();
  EXPECT_GT(number("F11_ciede2000"), 3);
  EXPECT_LT(number("F11_metamerism"), 0.1 * ofOthers);
}

TEST_F(ColourDifference, OfOneYarnInTwoColourways) {
  Fabric fabric = twoYarns(0);
  Fabric red = fabric;
  for (Fibre& fibre : red.fibres) fibre.absorption_per_mm = Rgb(2, 60, 60);
  fabric.colourways.push_back(colourwayOf(red, "Scarlet"));
  open(fabric);
  editor.choose("difference.sample", "straw");
  editor.choose("difference.sample_colourway", "Scarlet");
  editor.until("they differ", [&] { return editor.fact("difference.D65_cmc").ends_with("FAIL"); });
  untilJudged();
  EXPECT_GT(number("D65_ciede2000"), 20);
  EXPECT_EQ(editor.fact("dirty"), "no") << "looking is no edit";
}

TEST_F(ColourDifference, AYarnThatIsNotSeenIsSaid) {
  Fabric fabric = twoYarns(0);
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[2].name = "spare";
  open(fabric);
  editor.choose("difference.sample", "spare");
  editor.until("it is said", [&] { return editor.fact("difference.remark").starts_with("spare"); });
  EXPECT_EQ(editor.fact("difference.D65_cmc"), "\u2013");
}

}  // namespace
}  // namespace loomlight
