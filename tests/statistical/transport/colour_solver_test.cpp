#include "render/transport/colour_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/fabric/weave/structures.h"
#include "render/colour/colour_difference.h"
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
    const SolvedColour solved = solveColour(*walks, colouringInDaylight(fabric), kFirst, wanted);
    EXPECT_FALSE(solved.tooLight || solved.tooDark);
    fabric.fibres[0].absorption_per_mm = solved.absorption_per_mm;
    const Rgb rendered = renderedColours(fabric)[0];
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
    const SolvedReflectance solved = solveReflectance(*walks, colouringInDaylight(fabric), kFirst, swatch,
                                                      tristimulusWeights(illuminantNamed("D65"), Observer::degrees10));
    EXPECT_EQ(solved.tooLight + solved.tooDark, 0u);
    for (size_t j = 0; j < kBands; ++j) EXPECT_NEAR(solved.reached[j], swatch[j], 1e-4) << bandWavelength_nm(j);
    fabric.fibres[0].absorption_per_mm = Absorption(solved.absorption_per_mm);
    for (const StandardIlluminant lamp : {StandardIlluminant::d65, StandardIlluminant::f11}) {
      fabric.light.illuminant = lamp;
      const LinearWeights weights =
          linearWeights(illuminantNamed(lamp == StandardIlluminant::d65 ? "D65" : "F11"), Observer::degrees2);
      const Rgb rendered = renderedColours(fabric)[0];
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
  const Colouring undyed = colouringInDaylight(fabric);
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

// Where bands are out of reach, cutting each off spoils the hue: a search over smooth reflectances finds some that are
// nearer by a quarter and more.
TEST(ColourSolver, OfSheerClothSwatchesOutOfReachAreNearerThanCutOff) {
  Fabric fabric = test::whiteCotton();  // organza of two raw silks twisted together
  fabric.ends_per_cm = 48;
  fabric.picks_per_cm = 44;
  fabric.yarns[0].count_tex = 4.67;
  fabric.yarns[0].plies = 2;
  fabric.fibres[0].radius_um = 5.56;
  fabric.fibres[0].section = FibreSection::triangle;
  fabric.render.resolution = 4;
  const PatchOfCloth patch(fabric);
  const auto walks = tallyPathLengths(*patch.scene, *patch.medium, partOfFibre(0), 8192, Task{});
  ASSERT_TRUE(walks.has_value());
  const auto dyedWith = [&](float absorption_per_mm) {
    Spectrum bands;
    bands.fill(absorption_per_mm);
    Colouring dyed = colouringInDaylight(fabric);
    dyed.setBands(0, bands);
    return walks->reflectance(dyed).mean;
  };
  const Spectrum lightest = dyedWith(0), darkest = dyedWith(10000);
  const TristimulusWeights daylight = tristimulusWeights(illuminantNamed("D65"), Observer::degrees10);
  struct Named {
    const char* name;
    double plain, height, centre_nm, width_nm;
  };
  for (const Named& named : {Named{"pale pink", 0.4, 0.45, 650, 60}, Named{"navy", 0.002, 0.04, 450, 40},
                             Named{"maroon", 0.01, 0.2, 700, 60}, Named{"orange", 0.02, 0.75, 660, 70}}) {
    Spectrum swatch;
    for (size_t j = 0; j < kBands; ++j) {
      const double away = (bandWavelength_nm(j) - named.centre_nm) / named.width_nm;
      swatch[j] = static_cast<float>(named.plain + named.height * std::exp(-away * away));
    }
    const SolvedReflectance solved = solveReflectance(*walks, colouringInDaylight(fabric), kFirst, swatch, daylight);
    EXPECT_GT(solved.tooLight + solved.tooDark, 0u);
    Spectrum cutOff;
    for (size_t j = 0; j < kBands; ++j) {
      EXPECT_GE(solved.reached[j], darkest[j] - 1e-5) << named.name;
      EXPECT_LE(solved.reached[j], lightest[j] + 1e-5) << named.name;
      cutOff[j] = std::clamp(swatch[j], darkest[j], lightest[j]);
    }
    const auto difference = [&](const Spectrum& shown) {
      return ciede2000(labUnder(daylight, swatch), labUnder(daylight, shown));
    };
    EXPECT_LT(difference(solved.reached), 0.75 * difference(cutOff)) << named.name << " " << difference(cutOff);
  }
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
