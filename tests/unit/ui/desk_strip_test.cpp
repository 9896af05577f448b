#include <gtest/gtest.h>

#include "ui/desk.h"

namespace loomlight {
namespace {

TEST(DeskAreas, AStripTakesItsHeightFromTheViewportAlone) {
  const DeskLayout layout;
  const ImVec2 screen(1280, 720);
  const DeskAreas without = deskAreas(layout, screen, 31, 1), with = deskAreas(layout, screen, 31, 1, 92);
  EXPECT_EQ(without.strip.size.y, 0);
  EXPECT_EQ(with.strip.size.y, 92);
  EXPECT_EQ(with.strip.size.x, with.viewport.size.x);
  EXPECT_GT(with.strip.min.y, with.viewport.min.y + with.viewport.size.y) << "with a gap between them";
  EXPECT_EQ(with.strip.min.y + with.strip.size.y, without.viewport.min.y + without.viewport.size.y);
  EXPECT_EQ(with.draft.size.y, without.draft.size.y);
  EXPECT_EQ(with.inspector.size.y, without.inspector.size.y);
}

}  // namespace
}  // namespace loomlight
