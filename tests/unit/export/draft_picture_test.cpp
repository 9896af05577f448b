#include "app/export/draft_picture.h"

#include <gtest/gtest.h>

#include <map>

#include "core/fabric/weave/structure_edit.h"
#include "core/fabric/weave/structures.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "tests/support/picture_colours.h"

namespace loomlight {
namespace {

using test::coloursIn;
using test::Pixel;
using test::pixelAt;

Pixels8 pictureOf(const Fabric& fabric, int side) {
  return draftPicture(fabric, yarnReflectances(fabric), side, side);
}

Fabric twoColours(Weave weave) {
  Fabric fabric = withSecondYarn(Fabric{});
  fabric.weave = std::move(weave);
  fabric.weftSequence = {1};
  return fabric;
}

TEST(DraftPicture, ShowsTheYarnThatLiesOnTop) {
  const Fabric fabric = twoColours(twill(3, 1));
  const Pixels8 picture = pictureOf(fabric, 128);
  const std::map<Pixel, int> colours = coloursIn(picture);
  ASSERT_EQ(colours.size(), 2u);
  const Pixel warp =
      colours.begin()->second > colours.rbegin()->second ? colours.begin()->first : colours.rbegin()->first;
  EXPECT_EQ(colours.at(warp), 128 * 128 * 3 / 4) << "three in four crossings have the warp on top";
  for (int pick = 0; pick < 8; ++pick)
    for (int end = 0; end < 8; ++end)
      EXPECT_EQ(pixelAt(picture, 4 * end + 2, 127 - 4 * pick - 2) == warp, fabric.weave.warpOver(pick, end))
          << "the first pick is at the bottom";
}

TEST(DraftPicture, TellsWarpFromWeftInOneColour) {
  Fabric fabric;
  fabric.weave = twill(2, 2);
  EXPECT_EQ(coloursIn(pictureOf(fabric, 64)).size(), 2u);
}

TEST(DraftPicture, MixesWhatIsSmallerThanAPixel) {
  const std::map<Pixel, int> yarns = coloursIn(pictureOf(twoColours(twill(1, 1)), 64));
  ASSERT_EQ(yarns.size(), 2u);
  const int mean = (yarns.begin()->first[1] + yarns.rbegin()->first[1]) / 2;
  for (const auto& [colour, count] : coloursIn(pictureOf(twoColours(twill(1, 1).resized(512, 512)), 64)))
    EXPECT_NEAR(colour[1], mean, 40) << count << " pixels are of one yarn more than of the other";
}

/// Twice as many ends as picks to the cm: a crossing is twice as high as wide.
TEST(DraftPicture, HasCrossingsOfTheSettsShape) {
  Fabric fabric = twoColours(twill(3, 1));
  fabric.ends_per_cm = 40;
  fabric.picks_per_cm = 20;
  const Pixels8 picture = pictureOf(fabric, 128);
  Pixel warp = pixelAt(picture, 0, 127);
  if (!fabric.weave.warpOver(0, 0)) warp = pixelAt(picture, 4 * 1, 127);
  for (int pick = 0; pick < 8; ++pick)
    for (int end = 0; end < 8; ++end)
      EXPECT_EQ(pixelAt(picture, 4 * end + 2, 127 - 8 * pick - 4) == warp, fabric.weave.warpOver(pick, end));
}

}  // namespace
}  // namespace loomlight
