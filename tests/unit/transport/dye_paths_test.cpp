#include "render/transport/dye_paths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "render/colour/colour_space.h"

namespace loomlight {
namespace {

/// A third of the paths is lost, one in fifty never goes inside.
PathLengthTally someWalks(uint64_t seed, size_t count) {
  PathLengthTally paths;
  paths.materials = 1;
  paths.count = count;
  Random random(seed);
  for (size_t i = 0; i < count; ++i) {
    const float fate = random.uniform(), length_mm = -0.05f * std::log(1 - random.uniform());
    if (fate < 0.02f)
      paths.lengths_mm.push_back(0);
    else if (fate < 0.67f)
      paths.lengths_mm.push_back(length_mm);
  }
  return paths;
}

Lab labOf(const PathLengthTally& paths, const Rgb& absorption_per_mm) {
  return labFromLinear(glm::dvec3(paths.colour({absorption_per_mm})));
}

/// The report's tables dim light that comes straight from a lamp, so that its paths would bring parts of their light.
TEST(DyePaths, AreNeverTracedByTheReportsEstimator) {
  Fabric fabric;
  fabric.render.estimator = Estimator::report;
  ASSERT_TRUE(fabric.render.needsVisibility());
  EXPECT_EQ(colourPatch(fabric).render.estimator, Estimator::loomlight);
}

/// By so much tallies of other paths really are off, in any of these dyes; and in the worst of them by hardly less.
TEST(DyePaths, TheErrorIsThatOfManyTallies) {
  constexpr size_t kCount = 4096;
  constexpr int kTallies = 200;
  const double error = colourError(someWalks(1, kCount));
  const PathLengthTally truth = someWalks(2, 400 * kCount);
  double worst = 0;
  for (const Rgb& dye : {Rgb(0.0f), Rgb(16.0f), Rgb(128.0f), Rgb(0.0f, 128.0f, 128.0f), Rgb(128.0f, 0.0f, 128.0f),
                         Rgb(128.0f, 128.0f, 16.0f), Rgb(16.0f, 16.0f, 128.0f)}) {
    const Lab expected = labOf(truth, dye);
    double squares = 0;
    for (int i = 0; i < kTallies; ++i) {
      const double off = ciede2000(expected, labOf(someWalks(mixBits(static_cast<uint64_t>(i + 10)), kCount), dye));
      squares += off * off;
    }
    worst = std::max(worst, std::sqrt(squares / kTallies));
  }
  // 200 tallies know a root of the mean square to a twentieth; three of that, and as much for the one tally's guess.
  EXPECT_LT(worst, 1.3 * error);
  EXPECT_GT(worst, 0.6 * error) << "none of these dyes need be the worst";
}

TEST(DyePaths, FourTimesTheWalksHalveTheError) {
  EXPECT_NEAR(colourError(someWalks(3, 40000)) / colourError(someWalks(3, 10000)), 0.5, 0.05);
}

TEST(DyePaths, NothingIsKnownToErrWhereNothingIsSeen) {
  EXPECT_EQ(colourError(PathLengthTally{}), 0);
}

}  // namespace
}  // namespace loomlight
