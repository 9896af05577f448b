#include "render/transport/colour_solver.h"

#include <gtest/gtest.h>

#include <array>

#include "core/fabric/weave/structures.h"
#include "render/colour/colour_space.h"
#include "render/colour/tristimulus.h"
#include "tests/statistical/transport/rendered_colour.h"

namespace loomlight {
namespace {

constexpr size_t kWalks = 16384;
constexpr std::array<int, 1> kFirst = {0};
constexpr double kDeltaE = 1.0;  // of CIEDE2000: about the smallest that an eye sees

/// A twill of two yarns, of one fibre each; the weft is dyed.
Fabric twoYarns() {
  Fabric fabric = test::whiteCotton();
  fabric.weave = twill(2, 2);
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.yarns[0].hairiness_per_mm = 2;
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[1].absorption_per_mm = Rgb(30.0f, 12.0f, 4.0f);
  fabric.weftSequence = {1};
  fabric.ends_per_cm = 34;
  fabric.picks_per_cm = 30;
  fabric.render.resolution = 4;
  return fabric;
}

TEST(ColourSolver, SolvedClothRendersInTheWantedColour) {
  Fabric fabric = twoYarns();
  const PatchOfCloth patch(fabric);
  const auto walks = tallyPathLengths(*patch.scene, *patch.medium, partOfFibre(0), kWalks, Task{});
  ASSERT_TRUE(walks.has_value());
  ASSERT_EQ(walks->count, kWalks);
  for (const Rgb& wanted : {Rgb(0.25f, 0.10f, 0.04f), Rgb(0.06f, 0.12f, 0.20f)}) {
    const SolvedColour solved = solveColour(*walks, absorptionsOf(fabric), kFirst, wanted);
    EXPECT_FALSE(solved.tooLight || solved.tooDark);
    fabric.fibres[0].absorption_per_mm = solved.absorption_per_mm;
    const Rgb rendered = renderedColour(fabric, 0);
    EXPECT_LT(colourDifference(rendered, wanted), kDeltaE)
        << rendered.r << " " << rendered.g << " " << rendered.b << " for " << wanted.r;
  }
}

// A measured swatch becomes the absorption of this very cloth's fibre, and the picture has its colour, under the lamp
// that the picture is of.
TEST(ColourSolver, SolvedClothRendersAsItsSwatchWasMeasured) {
  Fabric fabric = twoYarns();
  const PatchOfCloth patch(fabric);
  const auto walks = tallyPathLengths(*patch.scene, *patch.medium, partOfFibre(0), kWalks, Task{});
  ASSERT_TRUE(walks.has_value());
  for (const double centre_nm : {460, 600}) {
    Spectrum swatch;
    for (size_t j = 0; j < kBands; ++j) {
      const double away = (bandWavelength_nm(j) - centre_nm) / 60;
      swatch[j] = static_cast<float>(0.08 + 0.2 * std::exp(-away * away));
    }
    const SolvedReflectance solved = solveReflectance(*walks, colouringInDaylight(fabric), kFirst, swatch);
    EXPECT_EQ(solved.tooLight + solved.tooDark, 0u);
    for (size_t j = 0; j < kBands; ++j) EXPECT_NEAR(solved.reached[j], swatch[j], 1e-4) << bandWavelength_nm(j);
    fabric.fibres[0].absorption_per_mm = Absorption(solved.absorption_per_mm);
    for (const StandardIlluminant lamp : {StandardIlluminant::d65, StandardIlluminant::f11}) {
      fabric.light.illuminant = lamp;
      const LinearWeights weights =
          linearWeights(illuminantNamed(lamp == StandardIlluminant::d65 ? "D65" : "F11"), Observer::degrees2);
      const Rgb rendered = renderedColour(fabric, 0);
      EXPECT_LT(colourDifference(rendered, Rgb(weighted(weights, swatch))), kDeltaE) << centre_nm;
    }
  }
}

TEST(ColourSolver, SheerClothCannotBeWhite) {
  Fabric fabric = twoYarns();
  fabric.ends_per_cm = fabric.picks_per_cm = 12;
  for (Yarn& yarn : fabric.yarns) yarn.count_tex = 5;
  const PatchOfCloth patch(fabric);
  const auto walks = tallyPathLengths(*patch.scene, *patch.medium, partOfFibre(0), 4096, Task{});
  ASSERT_TRUE(walks.has_value());
  const std::vector<Rgb> undyed = {Rgb(0.0f), fabric.fibres[1].absorption_per_mm.primaries};
  const Rgb white(0.95f);
  const SolvedColour solved = solveColour(*walks, undyed, kFirst, white);
  EXPECT_TRUE(solved.tooLight);
  EXPECT_LT(solved.reached.g, 0.9f);
  // The weft shines through in its blue. What looks nearest to white is no bluer than that, and hardly darker.
  const Rgb clear = walks->colour(undyed);
  EXPECT_EQ(Rgb(solved.absorption_per_mm.r, solved.absorption_per_mm.g, 0), Rgb(0.0f));
  const auto difference = [&white](const Rgb& colour) {
    return ciede2000(labFromLinear(glm::dvec3(white)), labFromLinear(glm::dvec3(colour)), 2);
  };
  EXPECT_LE(difference(solved.reached), difference(clear));
  EXPECT_LE(solved.reached.b, clear.b);
  EXPECT_GE(solved.reached.b, solved.reached.g);
}

TEST(ColourSolver, AFibreBelowTheFaceIsNotSeen) {
  Fabric fabric = twoYarns();
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[2].fibre = 2;
  fabric.fibres.push_back(fabric.fibres[0]);
  const PatchOfCloth patch(fabric);  // no thread uses it
  const auto walks = tallyPathLengths(*patch.scene, *patch.medium, partOfFibre(2), 256, Task{});
  ASSERT_TRUE(walks.has_value());
  EXPECT_EQ(walks->count, 0u);
}

}  // namespace
}  // namespace loomlight
