/// What the mill writes, on the page of the cloth: reed and denting, selvedges, and the setts from the reed to the
/// wash.
#include <gtest/gtest.h>

#include "tests/headless/editor/weaver.h"

namespace loomlight {
namespace {

class Mill : public testing::Test {
 protected:
  Mill() {
    Fabric cloth = smallTwill();
    cloth.ends_per_cm = 28;
    cloth.picks_per_cm = 20;
    cloth.press = 0;
    editor.start(cloth);
    editor.click("tab.cloth");
    editor.until("the cloth is measured", [&] { return editor.fact("cloth.reed_state_ends").starts_with("~"); });
  }
  MillData saved() { return editor.saved().mill; }

  HeadlessEditor editor{{1280, 1100}};  // all rows are in sight
};

TEST_F(Mill, ReedAndDentingSayWhatCrimpWasAskedBefore) {
  editor.edits("a reed", [&] { editor.enter("mill.reed_per_10cm", "125"); });
  editor.until("two in a dent", [&] { return editor.fact("cloth.reed_state_ends") == "25.0"; });
  editor.edits("an empty dent", [&] { editor.enter("mill.ends_per_dent", "3 3 0"); });
  EXPECT_EQ(editor.fact("cloth.reed_state_ends"), "25.0");
  editor.enter("mill.ends_per_dent", "3 x");
  editor.frame();
  EXPECT_EQ(saved().endsPerDent, (std::vector<int>{3, 3, 0})) << "what is no list is refused";
  EXPECT_EQ(saved().reed_per_10cm, 125);
  EXPECT_TRUE(editor.fact("cloth.contraction").starts_with("10.7 %")) << editor.fact("cloth.contraction");
}

TEST_F(Mill, CountsWhatCannotBeReckoned) {
  EXPECT_FALSE(editor.shows("cloth.washing_shrinkage")) << "not even of cloth that nothing presses";
  editor.edits("loom state", [&] { editor.enter("mill.loom_ends_per_cm", "26.5"); });
  editor.edits("washed", [&] { editor.enter("mill.washed_picks_per_cm", "21"); });
  EXPECT_EQ(saved().loomEnds_per_cm, 26.5);
  EXPECT_EQ(saved().washedPicks_per_cm, 21);
  EXPECT_EQ(editor.fact("cloth.washing_shrinkage"), "\xE2\x80\x93 \xC3\x97 4.8 %") << "picks get closer: it is shorter";
}

TEST_F(Mill, WritesSelvedges) {
  EXPECT_FALSE(editor.shows("mill.selvedge_weave"));
  editor.edits("24 on each side", [&] { editor.enter("mill.selvedge_ends", "24"); });
  editor.edits("four in a dent", [&] { editor.enter("mill.selvedge_ends_per_dent", "4"); });
  editor.edits("plain", [&] { editor.enter("mill.selvedge_weave", "plain"); });
  const MillData mill = saved();
  EXPECT_EQ(mill.selvedgeEnds, 24);
  EXPECT_EQ(mill.selvedgeEndsPerDent, 4);
  EXPECT_EQ(mill.selvedgeWeave, "plain");
  EXPECT_EQ(mill.selvedgeYarn, std::nullopt);
}

}  // namespace
}  // namespace loomlight
