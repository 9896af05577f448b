#include "render/optics/polynomials.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loomlight::optics {
namespace {

TEST(Polynomials, ExponentialIsAccurateDownToItsFloor) {
  for (float x = -39.9f; x <= 0; x += 0.0137f) {
    const double exact = std::exp(static_cast<double>(x));
    EXPECT_NEAR(exponential(broadcast<Float32x4>(x))[1] / exact, 1.0, x > -1 ? 2e-7 : 5e-6) << x;
  }
  EXPECT_EQ(exponential(broadcast<Float32x4>(0.0f))[0], 1.0f);
  EXPECT_NEAR(exponential(broadcast<Float32x4>(-1e30f))[2] / std::exp(-40.0), 1.0, 1e-5);
}

TEST(Polynomials, AngleFollowsThePairAllTheWayRound) {
  for (double t = -3.14159; t < 3.14159; t += 0.00071) {
    const auto sine = static_cast<float>(3 * std::sin(t)), cosine = static_cast<float>(3 * std::cos(t));
    EXPECT_NEAR(angle(broadcast<Float32x4>(sine), broadcast<Float32x4>(cosine))[3], std::abs(std::atan2(sine, cosine)),
                6e-7)
        << t;
  }
  EXPECT_EQ(angle(broadcast<Float32x4>(0.0f), broadcast<Float32x4>(1.0f))[0], 0.0f);
  EXPECT_EQ(angle(broadcast<Float32x4>(0.0f), broadcast<Float32x4>(0.0f))[0], 0.0f);
  EXPECT_FLOAT_EQ(angle(broadcast<Float32x4>(0.0f), broadcast<Float32x4>(-1.0f))[0], 3.14159265f);
}

TEST(Polynomials, SineAndCosineOfHalfTurns) {
  for (float y = -1; y <= 1; y += 0.00073f) {
    const SinCos<float> pair = sinCosPi(y);
    EXPECT_NEAR(pair.sine, std::sin(3.14159265358979 * y), 6e-7) << y;
    EXPECT_NEAR(pair.cosine, std::cos(3.14159265358979 * y), 6e-7) << y;
  }
}

TEST(Polynomials, LogarithmIsAccurateWhereSamplersUseIt) {
  for (float x = 0x1p-24f; x < 0x1p25f; x *= 1.0137f) {
    const double exact = std::log(static_cast<double>(x));
    EXPECT_NEAR(logarithm(x), exact, 2e-7 + 1.2e-7 * std::abs(exact)) << x;
  }
  for (float d = 0x1p-23f; d < 0.2f; d *= 2) {
    EXPECT_NEAR(logarithm(1 + d) / std::log1p(static_cast<double>(d)), 1.0, 1e-6) << d;
    EXPECT_NEAR(logarithm(1 - d) / std::log1p(-static_cast<double>(d)), 1.0, 1e-6) << d;
  }
  EXPECT_EQ(logarithm(1.0f), 0.0f);
  EXPECT_LT(logarithm(0.0f), -80.0f);
  EXPECT_TRUE(std::isfinite(logarithm(0.0f)));
}

TEST(Polynomials, BesselFunctionAgainstTheStandardLibrary) {
  for (double x = 0.01; x < 600; x *= 1.031) {
    const BesselI0<Float32x4> value = besselI0(broadcast<Float32x4>(static_cast<float>(std::sqrt(x))));
    const double scaled = static_cast<double>(value.factor[1]) * std::exp(-static_cast<double>(value.rest[1]));
    EXPECT_NEAR(scaled / (std::cyl_bessel_i(0.0, x) * std::exp(-x)), 1.0, 2e-6) << x;
  }
  EXPECT_EQ(besselI0(Float32x4{}).factor[0], 1.0f);
}

}  // namespace
}  // namespace loomlight::optics
