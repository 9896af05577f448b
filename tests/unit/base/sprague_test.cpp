#include "core/base/sprague.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace loomlight {
namespace {

std::vector<double> sampled(double (*curve)(double), int samples) {
  std::vector<double> values;
  for (int i = 0; i < samples; ++i) values.push_back(curve(i));
  return values;
}

TEST(Sprague, HasTheSamplesAndGoesOnSmoothly) {
  const std::vector<double> samples{3, -1, 4, 1, -5, 9, 2, 6};
  for (size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(sprague(samples, static_cast<double>(i)), samples[i]);
  constexpr double kStep = 1e-6;
  for (size_t i = 1; i + 1 < samples.size(); ++i) {
    const double at = static_cast<double>(i);
    const double before = (samples[i] - sprague(samples, at - kStep)) / kStep;
    const double after = (sprague(samples, at + kStep) - samples[i]) / kStep;
    EXPECT_NEAR(before, after, 1e-3) << i;
  }
}

/// The slopes at the samples are differences of four, exact for cubics; what is beyond the ends goes on straight.
TEST(Sprague, IsExactForCubicsInsideAndForLinesUpToTheEnds) {
  const auto cubic = [](double x) { return 2 - x + 0.5 * x * x - 0.1 * x * x * x; };
  const auto line = [](double x) { return 2 - x; };
  const std::vector<double> samples = sampled(cubic, 9), straight = sampled(line, 9);
  for (double at = 2; at <= 6; at += 0.1) EXPECT_NEAR(sprague(samples, at), cubic(at), 1e-10) << at;
  for (double at = 0; at <= 8; at += 0.1) EXPECT_NEAR(sprague(straight, at), line(at), 1e-10) << at;
}

TEST(Sprague, ComesCloseToASine) {
  const auto sine = [](double x) { return std::sin(0.5 * x); };
  const std::vector<double> samples = sampled(sine, 20);
  for (double at = 0; at <= 19; at += 0.05) EXPECT_NEAR(sprague(samples, at), sine(at), 1e-2) << at;
}

}  // namespace
}  // namespace loomlight
