#include "app/editor/display/cloth_sketch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "app/editor/model/yarn_close_up.h"
#include "core/base/rgb.h"
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

Pixel shown(const Rgb& linear) {
  const Rgb display = srgbFromLinear(linear);
  const auto step = [&](int c) { return static_cast<uint8_t>(std::lround(255 * display[c])); };
  return {step(0), step(1), step(2)};
}

Fabric twoColours() {
  Fabric fabric = withSecondYarn(Fabric{});
  fabric.weave = twill(3, 1);
  fabric.weftSequence = {1};
  fabric.fibres[0].absorption_per_mm = Rgb(40, 20, 5);
  fabric.render.width = 96;
  fabric.render.height = 64;
  return fabric;
}

TEST(ClothSketch, IsTheDraftInTheColoursOfItsYarns) {
  const Fabric fabric = twoColours();
  const Pixels8 sketch = clothSketch(fabric);
  EXPECT_EQ(sketch.width, 96);
  EXPECT_EQ(sketch.height, 64);
  ASSERT_EQ(sketch.bytes.size(), 3u * 96 * 64);
  const std::vector<Rgb> yarns = yarnReflectances(fabric);
  std::set<Pixel> colours;
  for (const auto& [colour, count] : coloursIn(sketch)) colours.insert(colour);
  EXPECT_EQ(colours, (std::set<Pixel>{shown(yarns[0]), shown(yarns[1])}));
}

TEST(ClothSketch, OfOneYarnIsAStrandOfItsColour) {
  const Fabric fabric = twoColours();
  const Pixels8 sketch = clothSketch(yarnCloseUp(fabric, 0, 90, 70));
  ASSERT_EQ(sketch.bytes.size(), 3u * 90 * 70);
  const Pixel yarn = shown(yarnReflectances(fabric)[0]), grey = shown(Rgb(0.18f));
  ASSERT_NE(yarn, grey);
  for (const int x : {0, 45, 89}) {
    EXPECT_EQ(pixelAt(sketch, x, 35), yarn);
    EXPECT_EQ(pixelAt(sketch, x, 0), grey);
    EXPECT_EQ(pixelAt(sketch, x, 69), grey);
  }
}

}  // namespace
}  // namespace loomlight
