#include "app/export/draft_sheet.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/structures.h"
#include "render/film/image.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

Pixels8 sheetOf(const Fabric& fabric) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("draft.png");
  writeDraftSheet(file, fabric, {});
  return readPng(file);
}

/// A weave of a jacquard, which has no threading: what the sheet is larger by is the crossings' alone.
TEST(DraftSheet, DrawsCrossingsInTheRatioOfTheSett) {
  Fabric fabric;
  fabric.weave = twill(3, 1).resized(100, 100);
  fabric.ends_per_cm = fabric.picks_per_cm = 20;
  const Pixels8 square = sheetOf(fabric);
  fabric.ends_per_cm = 30;
  const Pixels8 high = sheetOf(fabric);
  EXPECT_EQ(high.width, square.width);
  EXPECT_EQ(high.height - square.height, 100 * 8) << "crossings of 16 pixels are 24 high";
  std::swap(fabric.ends_per_cm, fabric.picks_per_cm);
  const Pixels8 wide = sheetOf(fabric);
  EXPECT_EQ(wide.height, square.height);
  EXPECT_EQ(wide.width - square.width, 100 * 8);
}

}  // namespace
}  // namespace loomlight
