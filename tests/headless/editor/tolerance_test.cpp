/// Whether the cloth passes beside a wanted colour, on the page of fibres.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/headless/editor/weaver.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::EndsWith;

class Tolerance : public testing::Test {
 protected:
  Tolerance() { editor.start(smallTwill()); }
  void untilMeasured() {
    editor.click("tab.fibre");
    editor.until("the cloth is measured", [&] { return editor.fact("fibre.cloth_colour_remark").starts_with("Pick"); });
  }
  void untilVerdict(const std::string& wanted) {
    editor.until("it is a " + wanted, [&] { return editor.fact("fibre.verdict").ends_with(wanted); });
  }
  /// A measured swatch that reflects little light of short waves and more of long ones.
  void dropBrown() {
    std::string head = "name", row = "made-up brown";
    for (int nm = 400; nm <= 700; nm += 20) {
      head += fmt::format(",{}", nm);
      row += fmt::format(",{:.4f}", 0.05 + (nm - 400) * 0.0007);
    }
    test::putBytes(folder.file("brown.csv"), fmt::format("{}\n{}\n", head, row));
    editor.edits("the cloth is dyed", [&] {
      editor.drop(folder.file("brown.csv"));
      editor.answer();  // that its numbers are fractions of 1 was guessed
    });
  }
  test::ScratchFolder folder;
  HeadlessEditor editor{{1280, 900, 1}};
};

/// Dyed as measured it passes under every lamp; the cloth as it was does not.
TEST_F(Tolerance, AClothPassesOrFailsBesideAMeasuredSwatch) {
  dropBrown();
  untilVerdict("pass");
  EXPECT_THAT(editor.fact("fibre.verdict_worst"), EndsWith("pass"));
  editor.edits("one step takes it back", [&] { editor.key("ctrl+z"); });
  untilVerdict("FAIL");
  EXPECT_THAT(editor.fact("fibre.verdict_worst"), EndsWith("FAIL"));
  EXPECT_NE(editor.fact("fibre.verdict_worst_lamp"), "D65") << "that is the cloth's own lamp";
  EXPECT_GT(std::stod(editor.fact("fibre.metamerism")), 0);
}

/// Under another lamp the same pair has other figures.
TEST_F(Tolerance, IsJudgedUnderTheLampOfTheCloth) {
  dropBrown();
  untilVerdict("pass");
  editor.edits("one step takes it back", [&] { editor.key("ctrl+z"); });
  untilVerdict("FAIL");
  const std::string inDaylight = editor.fact("fibre.verdict");
  editor.key("j");
  editor.until("the shop's lamp", [&] { return editor.fact("status.lamp") == "under F11"; });
  editor.until("it is judged there", [&] { return editor.fact("fibre.verdict") != inDaylight; });
  EXPECT_NE(editor.fact("fibre.verdict_worst_lamp"), "F11");
}

/// The number decides and is remembered; it is no edit of the cloth.
TEST_F(Tolerance, IsANumberThatIsRemembered) {
  untilMeasured();
  editor.edits("white is asked for", [&] { editor.enter("fibre.colour_code", "#ffffff"); });
  const auto far_cmc = [&] { return std::stod(editor.fact("fibre.verdict")); };
  editor.until("what was reached is judged, which no blue is", [&] { return far_cmc() < 19; });
  untilVerdict("FAIL");
  const std::string file = editor.fact("file");
  const Fabric cloth = editor.saved();
  const double far = far_cmc();
  editor.enter("fibre.tolerance", fmt::format("{:.2f}", far + 0.5));
  untilVerdict("pass");
  editor.enter("fibre.tolerance", fmt::format("{:.2f}", far - 0.5));
  untilVerdict("FAIL");
  editor.enter("fibre.tolerance", fmt::format("{:.2f}", far + 0.5));
  EXPECT_EQ(editor.saved(), cloth);
  editor.leave();
  editor.startOn(file);
  untilMeasured();
  editor.edits("a colour", [&] { editor.enter("fibre.colour_code", "Lab 60 20 20"); });
  editor.edits("white is asked for", [&] { editor.enter("fibre.colour_code", "#ffffff"); });
  editor.until("it is judged by the tolerance of before",
               [&] { return std::abs(far_cmc() - far) < 0.3 && editor.fact("fibre.verdict").ends_with("pass"); });
}

/// It has no spectrum: what other lamps would make of it is not claimed.
TEST_F(Tolerance, APickedColourIsJudgedInDaylightAlone) {
  untilMeasured();
  EXPECT_EQ(editor.fact("fibre.verdict"), "\u2013") << "nothing is wanted";
  editor.key("j");
  editor.until("the shop's lamp", [&] { return editor.fact("status.lamp") == "under F11"; });
  editor.edits("a code dyes", [&] { editor.enter("fibre.colour_code", "Lab 35 20 -40"); });
  untilVerdict("pass");
  EXPECT_EQ(editor.fact("fibre.verdict_worst"), "\u2013");
  EXPECT_EQ(editor.fact("fibre.verdict_worst_lamp"), "");
  EXPECT_EQ(editor.fact("fibre.metamerism"), "\u2013");
}

}  // namespace
}  // namespace loomlight
