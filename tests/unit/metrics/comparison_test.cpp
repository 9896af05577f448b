#include "render/metrics/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/metrics/pictures.h"

namespace loomlight {
namespace {

using test::noise;
using test::pairOf;
using test::picture;
using test::uniform;
using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

template <class Action>
std::string complaint(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Comparison, MeasuresOfUniformPicturesAreWhatTheirDefinitionsSay) {
  const Comparison c = compare(pairOf(uniform({0.55f, 0.4f, 0.2f}), uniform({0.5f, 0.5f, 0.2f})), {});
  EXPECT_NEAR(c.rmse, std::sqrt((0.05 * 0.05 + 0.1 * 0.1) / 3), 1e-7);
  const double epsilon = 0.01 * 0.4 * 0.4;
  EXPECT_NEAR(c.relMse, (0.05 * 0.05 + 0.1 * 0.1) / (0.25 + epsilon) / 3, 1e-7);
  EXPECT_NEAR(c.meanDifference_percent().r, 10, 1e-5);
  EXPECT_NEAR(c.meanDifference_percent().g, -20, 1e-5);
  EXPECT_NEAR(c.meanDifference_percent().b, 0, 1e-5);
  EXPECT_GT(c.ciede2000, 1);
  EXPECT_NEAR(c.flipMean, c.flipLargest, 1e-5);
}

TEST(Comparison, OfTheSameIsZero) {
  const Comparison c = compare(pairOf(noise(1), noise(1)), {});
  EXPECT_EQ(c.relMse, 0);
  EXPECT_EQ(c.rmse, 0);
  EXPECT_EQ(c.ciede2000, 0);
  EXPECT_EQ(c.flipLargest, 0);
  EXPECT_EQ(c.meanDifference_percent(), glm::dvec3(0));
}

TEST(Comparison, RelativeMeasuresDoNotMindTheUnitOfLight) {
  const Comparison one = compare(pairOf(noise(1), noise(2)), {});
  const Comparison eight = compare(pairOf(noise(1, 8), noise(2, 8)), {.exposure_stops = -3});
  EXPECT_NEAR(eight.relMse, one.relMse, 1e-6 * one.relMse);
  EXPECT_NEAR(eight.rmse, 8 * one.rmse, 1e-6 * eight.rmse);
  EXPECT_NEAR(eight.ciede2000, one.ciede2000, 1e-5);
  EXPECT_NEAR(eight.flipMean, one.flipMean, 1e-6);
}

TEST(Comparison, NonFinitePixelsAreCountedAndLeftOut) {
  LinearPicture a = uniform(Rgb(0.5f)), r = uniform(Rgb(0.4f));
  a.pixels[3].g = kNan;
  a.pixels[4].b = kInfinity;
  r.pixels[4].r = -kInfinity;
  const Comparison c = compare(pairOf(a, r), {});
  EXPECT_EQ(c.nonFinite, 2u);
  EXPECT_EQ(c.referenceNonFinite, 1u);
  EXPECT_NEAR(c.rmse, 0.1, 1e-7);
  EXPECT_NEAR(c.meanDifference_percent().g, 25, 1e-4);
  EXPECT_TRUE(std::isfinite(c.flipMean));
  EXPECT_THAT(complaint([] { compare(pairOf(uniform(Rgb(kNan)), uniform(Rgb(1))), {}); }), HasSubstr("finite"));
}

TEST(Comparison, BlackReferencesHaveNoRatios) {
  const Comparison c = compare(pairOf(uniform(Rgb(0.1f)), uniform(Rgb(0))), {});
  EXPECT_TRUE(std::isnan(c.relMse));
  EXPECT_TRUE(std::isnan(c.meanDifference_percent().r));
  EXPECT_NEAR(c.rmse, 0.1, 1e-7);
}

TEST(Comparison, SizesMustMatch) {
  const std::string message = complaint([] { compare(pairOf(uniform(Rgb(1), 4, 3), uniform(Rgb(1), 3, 4)), {}); });
  EXPECT_THAT(message, HasSubstr("a.exr: expected 3 x 4 pixels as in r.exr, got 4 x 3"));
}

TEST(NoiseFreeBias, IsTheSquaredDifferenceUnderTheNoise) {
  // Noise of 0.2 rms on a difference of 0.05 from 0.5: squares would give 0.085 / 0.25, this 0.0025 / 0.25.
  const auto noisy = [](float level, unsigned seed) {
    LinearPicture p = noise(seed, 0.7f, 400, 400);
    for (Rgb& c : p.pixels) c += Rgb(level - 0.35f);
    return p;
  };
  const Estimate bias =
      noiseFreeBiasEstimate(pairOf(noisy(0.55f, 1), noisy(0.5f, 2)), pairOf(noisy(0.55f, 3), noisy(0.5f, 4)));
  // Variance of a difference is v = 2 * 0.7^2 / 12 = 0.082; of a product of two about m = 0.05, v^2 + 2 m^2 v; and of
  // the mean of 480000 of these.
  const double v = 2 * 0.49 / 12, sigma = std::sqrt((v * v + 2 * 0.0025 * v) / 480000) / 0.25;
  EXPECT_NEAR(bias.value, 0.01, 5 * sigma);
  EXPECT_NEAR(bias.standardError, sigma, 0.02 * sigma);  // of a spread over 160000 pixels, 2 permille
}

TEST(NoiseFreeBias, OfTheSameExpectationIsNothing) {
  const double bias = noiseFreeBias(pairOf(noise(1, 1, 400, 400), noise(2, 1, 400, 400)),
                                    pairOf(noise(3, 1, 400, 400), noise(4, 1, 400, 400)));
  EXPECT_NEAR(bias, 0, 5 * (1.0 / 6) / std::sqrt(480000.0) / 0.25);
}

TEST(NoiseFreeBias, RefusesTheSameSeedTwice) {
  const PicturePair first{noise(1), noise(2), "a1.exr", "r1.exr"}, again{noise(1), noise(3), "a2.exr", "r2.exr"};
  EXPECT_THAT(complaint([&] { noiseFreeBias(first, again); }), HasSubstr("a2.exr: the very pixels of a1.exr"));
  const PicturePair reference{noise(3), noise(2), "a2.exr", "r2.exr"};
  EXPECT_THAT(complaint([&] { noiseFreeBias(first, reference); }), HasSubstr("r2.exr: the very pixels of r1.exr"));
}

TEST(NoiseFreeBias, LeavesOutWhatIsNotFiniteAnywhere) {
  PicturePair first = pairOf(uniform(Rgb(0.6f)), uniform(Rgb(0.5f))),
              second = pairOf(uniform(Rgb(0.6f)), uniform(Rgb(0.5f)));
  first.picture.pixels[0] = Rgb(kNan);
  second.reference.pixels[1] = Rgb(kInfinity);
  EXPECT_NEAR(noiseFreeBias(first, second), 0.04, 1e-6);
}

TEST(LinearPicture, NeedsRedGreenAndBlue) {
  Image image;
  image.width = image.height = 2;
  image.add("R");
  image.add("B");
  EXPECT_THAT(complaint([&] { linearPicture(image, "half.exr"); }), HasSubstr("half.exr: expected the channels"));
  image.add("G")[3] = 0.25f;
  EXPECT_EQ(linearPicture(image, "whole.exr").pixels[3], Rgb(0, 0.25f, 0));
}

TEST(LinearPicture, OfAPngIsTheLightThatAScreenGivesOff) {
  const test::ScratchFolder folder;
  writePng(folder.file("opaque.png"), Pixels8{2, 1, 3, {255, 0, 188, 10, 20, 30}});
  const LinearPicture opaque = readLinearPicture(folder.file("opaque.png"));
  ASSERT_EQ(opaque.pixels.size(), 2u);
  EXPECT_EQ(opaque.pixels[0].r, 1);
  EXPECT_EQ(opaque.pixels[0].g, 0);
  EXPECT_NEAR(opaque.pixels[0].b, 0.5, 0.004);  // of sRGB, 188 is half of the light of 255
  writePng(folder.file("half.PNG"), Pixels8{1, 1, 4, {255, 255, 0, 51}});
  EXPECT_EQ(readLinearPicture(folder.file("half.PNG")).pixels.at(0), Rgb(0.2f, 0.2f, 0)) << "over black";
}

}  // namespace
}  // namespace loomlight
