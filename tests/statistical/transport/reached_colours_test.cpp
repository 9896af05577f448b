#include "render/transport/reached_colours.h"

#include <gtest/gtest.h>

#include "core/fabric/weave/structures.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "tests/statistical/transport/rendered_colour.h"

namespace loomlight {
namespace {

/// A twill of a dark red warp and a melange weft, which is known in bands too.
Fabric redAndMelange() {
  Fabric fabric = test::whiteCotton();
  fabric.weave = twill(2, 2);
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.fibres.resize(3, fabric.fibres[0]);
  fabric.fibres[0].absorption_per_mm = Rgb(3.0f, 120.0f, 150.0f);
  fabric.yarns[1].fibre = 1;
  fabric.yarns[1].blendFibre = 2;
  fabric.yarns[1].blendShare = 0.4;
  Spectrum bluish;
  for (size_t j = 0; j < kBands; ++j) bluish[j] = 1 + static_cast<float>(j);
  fabric.fibres[2].absorption_per_mm = Absorption(bluish);
  fabric.weftSequence = {1};
  fabric.ends_per_cm = 34;
  fabric.picks_per_cm = 30;
  fabric.render.resolution = 4;
  return fabric;
}

// The bound that chips are held to: of CIEDE2000 against the picture, under the lamp that it is of. The green that so
// deep a red has left differs by 11 % from one chip to the next (standard deviation over seeds), which is more than
// 1 CIEDE2000: so that noise decides nothing, the paths of sixteen chips are taken together.
TEST(ReachedColours, AreThoseOfThePicture) {
  constexpr double kChip = 1.5, kSoon = 3;
  Fabric fabric = redAndMelange();
  const auto paths = tracePathsToYarns(fabric, 16 * kChipPaths, Task{});
  ASSERT_TRUE(paths);
  for (const StandardIlluminant lamp : {StandardIlluminant::d65, StandardIlluminant::a, StandardIlluminant::f11}) {
    fabric.light.illuminant = lamp;
    const std::vector<Rgb> reached = reachedColours(*paths, colouringOf(fabric));
    const auto soon = soonReachedColours(fabric, Task{});
    ASSERT_TRUE(soon);
    const std::vector<Rgb> rendered = renderedColours(fabric);
    ASSERT_EQ(rendered.size(), 2u);
    for (size_t i = 0; i < rendered.size(); ++i) {
      EXPECT_LT(colourDifference(reached[i], rendered[i]), kChip)
          << "lamp " << static_cast<int>(lamp) << ", yarn " << i;
      EXPECT_LT(colourDifference((*soon)[i], rendered[i]), kSoon)
          << "lamp " << static_cast<int>(lamp) << ", yarn " << i;
    }
  }
}

}  // namespace
}  // namespace loomlight
