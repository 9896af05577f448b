#include <gtest/gtest.h>

#include "ui/dock_layout.h"

namespace loomlight {
namespace {

TEST(DockAreas, AStripTakesItsHeightFromTheViewportAlone) {
  const DockLayout layout;
  const ImVec2 screen(1280, 720);
  const DockAreas without = dockAreas(layout, screen, 31, 1), with = dockAreas(layout, screen, 31, 1, 92);
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
