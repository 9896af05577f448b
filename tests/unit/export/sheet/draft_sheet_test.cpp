#include "app/export/sheet/draft_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "core/base/file.h"
#include "core/base/rgb.h"
#include "core/fabric/weave/structures.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "render/film/image.h"
#include "render/transport/reached_colours.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

Pixels8 sheetOf(const Fabric& fabric) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("draft.png");
  EXPECT_TRUE(writeDraftSheet(file, fabric, {}, {}));
  EXPECT_THAT(readFile(file, 50'000'000), testing::HasSubstr("sRGB")) << "as all our pictures say";
  return readPng(file);
}

/// Coarse fibres, through which light is soon walked.
Fabric coarseCloth() {
  Fabric fabric;
  fabric.yarns[0].fibresPerPly = 20;
  fabric.yarns[0].layout = FibreLayout::random;
  fabric.fibres[0].radius_um = 20;
  fabric.render.resolution = 1;
  return fabric;
}

/// A weave of a jacquard, which has no threading: what the sheet is larger by is the crossings' alone.
TEST(DraftSheet, DrawsCrossingsInTheRatioOfTheSett) {
  Fabric fabric = coarseCloth();
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

/// A dark red is darker in the cloth than its dye is in a thick mass.
TEST(DraftSheet, BarsHaveTheColoursThatTheClothReaches) {
  Fabric fabric = coarseCloth();
  fabric.weave = twill(2, 2);
  fabric.fibres[0].absorption_per_mm = Rgb(12.0f, 150.0f, 180.0f);
  const Pixels8 sheet = sheetOf(fabric);
  // Margin and title, then the bar of the first end: cells of 16 pixels, of which two are beside the drawdown.
  const size_t x = 16 + 2 * 16 + 8, y = 16 + 28 + 8;
  const auto expected = [](const Rgb& linear, int c) { return 255 * srgbFromLinear(linear)[c]; };
  const Rgb reached = (*reachedColours(fabric, {}))[0], dye = fibreReflectance(fabric.fibres[0]);
  ASSERT_GT(std::abs(expected(dye, 0) - expected(reached, 0)), 4) << "nothing is told apart";
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(sheet.bytes[3 * (y * static_cast<size_t>(sheet.width) + x) + static_cast<size_t>(c)],
                expected(reached, c), 2);
}

TEST(DraftSheet, WhatIsStoppedLeavesNoFile) {
  const test::ScratchFolder folder;
  std::stop_source stop;
  stop.request_stop();
  Task task;
  task.stop = stop.get_token();
  EXPECT_FALSE(writeDraftSheet(folder.file("draft.pdf"), coarseCloth(), {}, task));
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace loomlight
