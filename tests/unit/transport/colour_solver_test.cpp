#include "render/transport/colour_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "render/colour/colour_difference.h"
#include "tests/support/narrow_dye.h"

namespace loomlight {
namespace {

/// Two materials; one walk in five does not come back.
PathLengthTally someWalks() {
  PathLengthTally walks;
  walks.materials = 2;
  walks.count = 500;
  Random random(3);
  for (int i = 0; i < 400; ++i) {
    walks.lengths_mm.push_back(i < 5 ? 0.0f : -0.05f * std::log(1 - random.uniform()));
    walks.lengths_mm.push_back(0.01f * random.uniform());
  }
  return walks;
}

constexpr std::array<int, 1> kFirst = {0};
constexpr std::array<int, 2> kBoth = {0, 1};

/// In daylight.
Colouring colouring(const Rgb& first, const Rgb& second) {
  Colouring colouring;
  colouring.primaries_per_mm = {first, second};
  return colouring;
}
const Colouring kColouring = colouring(Rgb(0.0f), Rgb(2.0f, 20.0f, 40.0f));

TEST(ColourSolver, ReachesWhatItPromises) {
  const Rgb wanted(0.6f, 0.2f, 0.05f);
  const SolvedColour solved = solveColour(someWalks(), kColouring, kFirst, wanted);
  EXPECT_FALSE(solved.tooLight || solved.tooDark);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(solved.reached[c], wanted[c], 1e-4);
  EXPECT_GT(solved.absorption_per_mm.b, solved.absorption_per_mm.g);
  EXPECT_EQ(someWalks().colour(colouring(solved.absorption_per_mm, kColouring.primaries_per_mm[1])), solved.reached);
}

TEST(ColourSolver, SaysWhatIsTooLightAndTakesNoDye) {
  const SolvedColour solved = solveColour(someWalks(), kColouring, kFirst, Rgb(0.9f, 0.3f, 0.1f));
  EXPECT_TRUE(solved.tooLight);
  EXPECT_FALSE(solved.tooDark);
  EXPECT_EQ(solved.absorption_per_mm.r, 0);
  EXPECT_LT(solved.reached.r, 0.81f) << "of five walks four come back";
}

TEST(ColourSolver, APastelThatIsTooLightKeepsItsHue) {
  const SolvedColour solved =
      solveColour(someWalks(), colouring(Rgb(0.0f), Rgb(0.0f)), kFirst, Rgb(1.0f, 0.85f, 0.88f));
  EXPECT_TRUE(solved.tooLight);
  EXPECT_GT(solved.reached.r, solved.reached.g + 0.05f);
  EXPECT_GT(solved.reached.r, solved.reached.b + 0.03f);
}

TEST(ColourSolver, SaysWhatIsTooDarkAndTakesNoMoreDyeThanShows) {
  // Five walks in five hundred never went inside: nothing is darker than 0.01.
  const SolvedColour solved =
      solveColour(someWalks(), colouring(Rgb(0.0f), Rgb(0.0f)), kFirst, Rgb(0.002f, 0.3f, 0.3f));
  EXPECT_TRUE(solved.tooDark);
  EXPECT_FALSE(solved.tooLight);
  EXPECT_NEAR(solved.reached.r, 0.011f, 1e-3);
  EXPECT_LT(solved.absorption_per_mm.r, 9500);
}

TEST(ColourSolver, AFibreThatIsNeverOnTopHasNoColour) {
  EXPECT_EQ(PathLengthTally{}.colour(std::vector<Rgb>{}), Rgb(0.0f));
}

TEST(ColourSolver, DyesAPieceAlikeAndForgetsWhatItsFibresHad) {
  const Rgb wanted(0.5f, 0.3f, 0.1f);
  const SolvedColour solved = solveColour(someWalks(), kColouring, kBoth, wanted);
  const std::vector<Rgb> alike(2, solved.absorption_per_mm);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(someWalks().colour(alike)[c], wanted[c], 1e-4);
  // A fibre alone takes more of it, since the other's lengths do not count.
  const SolvedColour one = solveColour(someWalks(), colouring(Rgb(0.0f), Rgb(0.0f)), kFirst, wanted);
  for (int c = 0; c < 3; ++c) EXPECT_GT(one.absorption_per_mm[c], solved.absorption_per_mm[c]);
}

TEST(ColourSolver, ReachesAColourBesideADyeThatIsKnownInBands) {
  Fabric white;
  white.fibres.assign(2, Fibre{});
  for (Fibre& fibre : white.fibres) fibre.absorption_per_mm = Rgb(0.0f);
  Colouring beside = colouringInDaylight(white);
  beside.setBands(1, test::narrowDye(200));
  const Rgb wanted(0.4f, 0.15f, 0.25f);
  const SolvedColour solved = solveColour(someWalks(), beside, kFirst, wanted);
  EXPECT_FALSE(solved.tooLight || solved.tooDark);
  beside.primaries_per_mm[0] = solved.absorption_per_mm;
  const Rgb shown = someWalks().colour(beside);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], wanted[c], 1e-4);
}

TEST(ColourSolver, AFibreForgetsTheBandsThatItHad) {
  Colouring dyed = kColouring, plain = kColouring;
  dyed.setBands(0, test::narrowDye(40));
  plain.primaries_per_mm[0] = Rgb(0.0f);
  const Rgb wanted(0.6f, 0.2f, 0.05f);
  EXPECT_EQ(solveColour(someWalks(), dyed, kFirst, wanted).absorption_per_mm,
            solveColour(someWalks(), plain, kFirst, wanted).absorption_per_mm);
}

Spectrum spectrumOf(const std::function<double(double nm)>& at) {
  Spectrum reflectance;
  for (size_t j = 0; j < kBands; ++j) reflectance[j] = static_cast<float>(at(bandWavelength_nm(j)));
  return reflectance;
}

const TristimulusWeights kDaylight = tristimulusWeights(illuminantNamed("D65"), Observer::degrees10);

TEST(ColourSolver, ASwatchWithinReachIsMatchedInEveryBand) {
  const Spectrum wanted = spectrumOf([](double nm) { return 0.1 + 0.001 * (nm - 380); });
  const SolvedReflectance solved = solveReflectance(someWalks(), kColouring, kFirst, wanted, kDaylight);
  EXPECT_EQ(solved.tooLight + solved.tooDark, 0u);
  for (size_t j = 0; j < kBands; ++j) EXPECT_NEAR(solved.reached[j], wanted[j], 1e-4);
}

/// Long waves are lighter than the four walks in five that come back: less of the others keeps the hue.
TEST(ColourSolver, ASwatchOutOfReachLooksNearerThanCutOff) {
  const Colouring undyed = colouring(Rgb(0.0f), Rgb(0.0f));
  const Spectrum wanted = spectrumOf([](double nm) { return nm < 580 ? 0.6 : 1.0; });
  const SolvedReflectance solved = solveReflectance(someWalks(), undyed, kFirst, wanted, kDaylight);
  EXPECT_GT(solved.tooLight, 0u);
  Spectrum cutOff = wanted;
  for (float& band : cutOff) band = std::min(band, 0.8f);
  const Lab standard = labUnder(kDaylight, wanted);
  EXPECT_LT(ciede2000(standard, labUnder(kDaylight, solved.reached)),
            0.75 * ciede2000(standard, labUnder(kDaylight, cutOff)));
}

}  // namespace
}  // namespace loomlight
