#include "render/scene/pixel_filter.h"

#include <gtest/gtest.h>

#include "core/base/units.h"

namespace loomlight {
namespace {

constexpr int kSamples = 4000;

/// What is left of a wave of so many cycles a pixel, by evenly spread samples.
double left(double cycles) {
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / kSamples;
    sum += std::cos(2 * kPi * cycles * (TriangleFilter::sample({u, 0.5f}).x - 0.5));
  }
  return sum / kSamples;
}

TEST(TriangleFilter, ReachesAPixelBeyondItsOwnOnEachSide) {
  EXPECT_NEAR(TriangleFilter::sample({0, 0}).x, -0.5f, 1e-6f);
  EXPECT_NEAR(TriangleFilter::sample({0.5f, 0.5f}).y, 0.5f, 1e-6f);
  EXPECT_NEAR(TriangleFilter::sample({1 - 1e-7f, 0}).x, 1.5f, 1e-3f);
}

/// The Fourier transform of a triangle is the square of that of its box. A wave moves by less than 2 pi f / kSamples
/// times the filter's greatest stretch of a stratum, at its ends, of sqrt(2 / kSamples).
TEST(TriangleFilter, LeavesTheSquareOfWhatABoxWouldLeave) {
  for (const double cycles : {0.25, 0.5, 0.8, 1.4, 2.5}) {
    const double box = std::sin(kPi * cycles) / (kPi * cycles);
    EXPECT_NEAR(left(cycles), box * box, 1e-3) << cycles;
  }
}

}  // namespace
}  // namespace loomlight
