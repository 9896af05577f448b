/// The cloth under all lamps of the light booth, side by side.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/fabric/model/booth_lamps.h"
#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/lamp_name.h"
#include "tests/headless/editor/weaver.h"
#include "tests/support/narrow_dye.h"

namespace loomlight {
namespace {

using testing::StartsWith;

/// Of one dye that every lamp shows as another colour; it fills the view, so that all parts of that look alike.
Fabric dyedCloth() {
  Fabric cloth = smallTwill();
  cloth.fibres[0].absorption_per_mm = Absorption(test::narrowDye(60));
  for (Yarn& yarn : cloth.yarns) yarn.fibre = 0;
  cloth.camera.elevation_deg = 90;
  cloth.drape.width_mm = cloth.drape.height_mm = 48;
  cloth.camera.distance_mm = 120;
  return cloth;
}

std::string nameOf(StandardIlluminant lamp) {
  return choiceName(lamp);
}

class Booth : public testing::Test {
 protected:
  Booth() {
    editor.start(dyedCloth());
    editor.untilPictured();
  }
  /// Linear: the mean of what is seen, as a fact says it.
  Rgb light(const std::string& fact) {
    std::istringstream text(editor.fact(fact));
    Rgb mean(-1.0f);
    text >> mean.r >> mean.g >> mean.b;
    return mean;
  }
  /// Of all its light, the share that is red, green and blue.
  static Rgb chromaticity(Rgb light) { return light / (light.r + light.g + light.b); }
  void untilDivided() {
    editor.until("the picture is divided", [&] { return editor.shows("booth.f11"); });
  }
  HeadlessEditor editor{{640, 450, 0.5f}};  // of few pixels
};

/// What J shows one after the other, Shift+J shows at once: the colour of each quarter is nearer to that of its own
/// lamp's picture than half of the way to any other lamp's. Brightness says nothing: quarters show the middle alone.
TEST_F(Booth, EachQuarterShowsWhatItsLampShows) {
  std::vector<Rgb> alone;
  for (size_t i = 0; i < kBoothLamps.size(); ++i) {
    ASSERT_EQ(editor.shows("status.lamp") ? editor.fact("status.lamp") : "under D65",
              "under " + lampName({kBoothLamps[i]}));
    editor.until("the picture rests", [&] { return editor.number("shown_samples") == 1; });
    alone.push_back(chromaticity(light("shown_light")));
    const uint64_t generation = editor.number("generation");
    editor.key("j");
    editor.until("the next lamp", [&] { return editor.number("generation") > generation; });
    editor.untilPictured();
  }
  editor.key("shift+j");
  untilDivided();
  for (size_t i = 0; i < alone.size(); ++i) {
    const Rgb quarter = chromaticity(light("booth.light." + nameOf(kBoothLamps[i])));
    for (size_t k = 0; k < alone.size(); ++k) {
      if (k == i) continue;
      EXPECT_LT(2 * glm::length(quarter - alone[i]), glm::length(alone[k] - alone[i])) << i << k;
    }
  }
}

TEST_F(Booth, QuartersStandInTheOrderOfTheLamps) {
  editor.key("shift+j");
  untilDivided();
  const HeadlessEditor::Rect whole = editor.rect("viewport");
  for (size_t i = 0; i < kBoothLamps.size(); ++i) {
    const HeadlessEditor::Rect quarter = editor.rect("booth." + nameOf(kBoothLamps[i]));
    const float middleX = 0.5f * (whole.x0 + whole.x1), middleY = 0.5f * (whole.y0 + whole.y1);
    EXPECT_EQ(quarter.x0 > middleX - 2, i % 2 == 1) << i;
    EXPECT_EQ(quarter.y0 > middleY - 2, i / 2 == 1) << i;
  }
}

/// Nothing to undo or to save, and the next session looks at the cloth likewise.
TEST_F(Booth, IsAViewAndIsRemembered) {
  const Fabric before = editor.saved();
  const std::string revision = editor.fact("revision"), file = editor.fact("file");
  const uint64_t generation = editor.number("generation");
  editor.click("menu.view");
  editor.click("menu.booth");
  untilDivided();
  EXPECT_EQ(editor.fact("dirty"), "no");
  EXPECT_EQ(editor.fact("revision"), revision);
  EXPECT_EQ(editor.number("generation"), generation) << "nothing is traced anew";
  EXPECT_EQ(editor.saved(), before);
  editor.leave();
  editor.startOn(file);
  untilDivided();
  editor.key("shift+j");
  editor.until("it is whole again", [&] { return !editor.shows("booth.f11"); });
  EXPECT_EQ(editor.fact("booth.light.f11"), "");
}

/// All quarters show the same piece of the cloth, and the mouse finds the same crossing in each.
TEST_F(Booth, TheSameCrossingIsUnderTheMouseInEveryQuarter) {
  editor.key("shift+j");
  untilDivided();
  editor.until("what is where is known of each pixel", [&] { return editor.number("shown_samples") > 0; });
  std::vector<std::string> found;
  for (const StandardIlluminant lamp : kBoothLamps) {
    const HeadlessEditor::Rect quarter = editor.rect("booth." + nameOf(lamp));
    editor.move(ImVec2(quarter.x0 + 60, quarter.y0 + 80));
    editor.frame();  // the panel says in a frame what was under the mouse in the one before
    editor.frame();
    found.push_back(editor.fact("view.under"));
  }
  EXPECT_THAT(found, testing::Each(StartsWith("End ")));
  EXPECT_THAT(found, testing::Each(found[0]));
}

/// Colours are judged there: whatever else was chosen, no curve bends them, and no exposure shifts them.
TEST_F(Booth, IsShownInThePlainTone) {
  editor.enter("view.exposure", "2");
  EXPECT_EQ(editor.fact("view.ways"), "");
  const auto untilPlain = [&](bool plain) {
    editor.until(plain ? "the tone is plain" : "the tone has its curve again",
                 [&] { return (editor.fact("view.ways") == "Plain tone") == plain; });
    EXPECT_EQ(editor.fact("view.exposure"), plain ? "0 EV" : "2.0 EV");
  };
  editor.key("shift+j");
  untilPlain(true);
  editor.click("menu.view");
  EXPECT_EQ(editor.fact("menu.plain_tone"), "ticked");
  editor.click("menu.plain_tone");  // in vain
  editor.key("Escape");
  untilPlain(true);
  editor.key("shift+j");
  untilPlain(false);
  editor.edits("the light is the booth's", [&] { editor.choose("view.light", "Light booth"); });
  untilPlain(true);
  editor.edits("it is another", [&] { editor.choose("view.light", "Overcast"); });
  untilPlain(false);
}

/// The lens has its place in the whole view: either is shut for the other.
TEST_F(Booth, GivesWayToTheLensAndTheLensToIt) {
  editor.key("shift+j");
  untilDivided();
  editor.key("l");
  editor.until("the lens is chosen", [&] { return editor.fact("lens_tool") == "chosen"; });
  editor.until("the view is whole", [&] { return !editor.shows("booth.f11"); });
  editor.key("shift+j");
  untilDivided();
  EXPECT_EQ(editor.fact("lens_tool"), "off");
}

}  // namespace
}  // namespace loomlight
