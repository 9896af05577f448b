#include "render/transport/colour_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

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
const std::vector<Rgb> kAbsorptions = {Rgb(0.0f), Rgb(2.0f, 20.0f, 40.0f)};

TEST(ColourSolver, ReachesWhatItPromises) {
  const Rgb wanted(0.6f, 0.2f, 0.05f);
  const SolvedColour solved = solveColour(someWalks(), kAbsorptions, kFirst, wanted);
  EXPECT_FALSE(solved.tooLight || solved.tooDark);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(solved.reached[c], wanted[c], 1e-4);
  EXPECT_GT(solved.absorption_per_mm.b, solved.absorption_per_mm.g);
  EXPECT_EQ(someWalks().colour({solved.absorption_per_mm, kAbsorptions[1]}), solved.reached);
}

TEST(ColourSolver, SaysWhatIsTooLightAndTakesNoDye) {
  const SolvedColour solved = solveColour(someWalks(), kAbsorptions, kFirst, Rgb(0.9f, 0.3f, 0.1f));
  EXPECT_TRUE(solved.tooLight);
  EXPECT_FALSE(solved.tooDark);
  EXPECT_EQ(solved.absorption_per_mm.r, 0);
  EXPECT_LT(solved.reached.r, 0.81f) << "of five walks four come back";
}

TEST(ColourSolver, APastelThatIsTooLightKeepsItsHue) {
  const SolvedColour solved = solveColour(someWalks(), {Rgb(0.0f), Rgb(0.0f)}, kFirst, Rgb(1.0f, 0.85f, 0.88f));
  EXPECT_TRUE(solved.tooLight);
  EXPECT_GT(solved.reached.r, solved.reached.g + 0.05f);
  EXPECT_GT(solved.reached.r, solved.reached.b + 0.03f);
}

TEST(ColourSolver, SaysWhatIsTooDarkAndTakesNoMoreDyeThanShows) {
  // Five walks in five hundred never went inside: nothing is darker than 0.01.
  const SolvedColour solved = solveColour(someWalks(), {Rgb(0.0f), Rgb(0.0f)}, kFirst, Rgb(0.002f, 0.3f, 0.3f));
  EXPECT_TRUE(solved.tooDark);
  EXPECT_FALSE(solved.tooLight);
  EXPECT_NEAR(solved.reached.r, 0.011f, 1e-3);
  EXPECT_LT(solved.absorption_per_mm.r, 9000);
}

TEST(ColourSolver, AFibreThatIsNeverOnTopHasNoColour) {
  EXPECT_EQ(PathLengthTally{}.colour(std::vector<Rgb>{}), Rgb(0.0f));
}

TEST(ColourSolver, DyesAPieceAlikeAndForgetsWhatItsFibresHad) {
  const Rgb wanted(0.5f, 0.3f, 0.1f);
  const SolvedColour solved = solveColour(someWalks(), kAbsorptions, kBoth, wanted);
  const std::vector<Rgb> alike(2, solved.absorption_per_mm);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(someWalks().colour(alike)[c], wanted[c], 1e-4);
  // A fibre alone takes more of it, since the other's lengths do not count.
  const SolvedColour one = solveColour(someWalks(), {Rgb(0.0f), Rgb(0.0f)}, kFirst, wanted);
  for (int c = 0; c < 3; ++c) EXPECT_GT(one.absorption_per_mm[c], solved.absorption_per_mm[c]);
}

}  // namespace
}  // namespace loomlight
