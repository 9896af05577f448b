#include <gtest/gtest.h>

#include <vector>

#include "tests/headless/editor/headless_editor.h"

namespace loomlight {
namespace {

using Spacing = std::vector<double>;

TEST(Sett, DistancesOfThreadsAreTypedAsTheyRepeat) {
  HeadlessEditor editor{{1280, 1100}};  // all rows are in sight
  Fabric cloth;
  cloth.yarns[0].count_tex = 60;
  cloth.ends_per_cm = cloth.picks_per_cm = 8;
  editor.start(cloth);
  editor.click("tab.cloth");
  EXPECT_TRUE(editor.saved().warpSpacing.empty());
  editor.edits("ends in pairs", [&] { editor.enter("cloth.warp_spacing", "1 2"); });
  EXPECT_EQ(editor.saved().warpSpacing, (Spacing{1, 2}));
  editor.enter("cloth.warp_spacing", "1 two");
  editor.frame();
  EXPECT_EQ(editor.saved().warpSpacing, (Spacing{1, 2})) << "what is no list is refused";
  editor.edits("picks in threes", [&] { editor.enter("cloth.weft_spacing", "1 1 9"); });
  EXPECT_EQ(editor.saved().weftSpacing, (Spacing{1, 1, 9}));
  // Farther than the cells of a thread reach.
  editor.until("it is said that there is no room", [&] { return editor.shows("cloth.remarks"); });
  editor.edits("even again", [&] { editor.enter("cloth.weft_spacing", " "); });
  EXPECT_TRUE(editor.saved().weftSpacing.empty());
}

}  // namespace
}  // namespace loomlight
