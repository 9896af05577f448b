#include "core/volume/pool/tangent_spread.h"

#include <gtest/gtest.h>

namespace loomlight {
namespace {

constexpr double kDegree = kPi / 180;

double fromTable(double alpha, double spread) {
  return TangentSpread::table().projectedLength(static_cast<float>(std::sin(alpha)), static_cast<float>(spread));
}

// Values integrated by an independent program, three digits.
TEST(TangentSpread, IntegralHasKnownValues) {
  const struct {
    double spread, alpha_deg, value;
  } known[] = {{.1, 0, .1246}, {.1, 5, .147},  {.1, 10, .204}, {.1, 20, .3535}, {.1, 45, .707}, {.1, 90, .995},
               {.3, 0, .359},  {.3, 10, .385}, {.3, 30, .554}, {.3, 90, .957},  {.8, 0, .728},  {.8, 90, .813}};
  for (const auto& k : known)
    EXPECT_NEAR(TangentSpread::projectedLengthExact(k.alpha_deg * kDegree, k.spread), k.value, 1e-3)
        << k.spread << " " << k.alpha_deg;
}

TEST(TangentSpread, AlongTheMeanASmallSpreadShowsRayleighsMean) {
  for (const double s : {1e-4, 1e-3, 1e-2})
    EXPECT_NEAR(TangentSpread::projectedLengthExact(0, s) / s, std::sqrt(kPi / 2), 2e-4) << s;
}

TEST(TangentSpread, TableIsWithinATenthOfAPercentOfTheIntegral) {
  double worst = 0;
  for (const double s : {0.0, 1e-4, .001, .004, .01, .017, .03, .05, .08, .11, .16, .24, .37, .5, .63, .77, .9, 1.0})
    for (double alpha = 0; alpha <= 90.001; alpha += alpha < 3 ? .25 : 1.75) {
      const double exact = TangentSpread::projectedLengthExact(alpha * kDegree, s);
      if (exact == 0) {
        EXPECT_EQ(fromTable(alpha * kDegree, s), 0);
        continue;
      }
      const double error = std::abs(fromTable(alpha * kDegree, s) / exact - 1);
      EXPECT_LT(error, 1e-3) << "s " << s << " alpha " << alpha;
      worst = std::max(worst, error);
    }
  RecordProperty("worst_relative_error", std::to_string(worst));
}

TEST(TangentSpread, WithoutSpreadItIsTheSine) {
  for (float sine = 0; sine <= 1; sine += 0.01f)
    EXPECT_NEAR(TangentSpread::table().projectedLength(sine, 0), sine, 2e-7f);
}

// The bound that a traversal with majorant 2 r lambda relies on.
TEST(TangentSpread, NeverAboveOne) {
  for (float sine = 0; sine <= 1; sine += 1.0f / 512)
    for (float s = 0; s <= 1; s += 1.0f / 512) ASSERT_LE(TangentSpread::table().projectedLength(sine, s), 1);
}

TEST(TangentSpread, SpreadInvertsItsMeanSquareSine) {
  // Towards s = 1 the mean-square sine flattens out, so there its inverse is less certain; still half the step of a
  // Component's spread.
  for (double s = 0; s <= 1.0; s += 0.013)
    EXPECT_NEAR(TangentSpread::spreadFromMeanSquareSine(TangentSpread::meanSquareSine(s)), s,
                s < 0.85 ? 2e-4 * s + 1e-9 : 4e-3)
        << s;
  EXPECT_EQ(TangentSpread::spreadFromMeanSquareSine(0), 0);
  EXPECT_EQ(TangentSpread::spreadFromMeanSquareSine(-1e-17), 0);
  EXPECT_EQ(TangentSpread::spreadFromMeanSquareSine(2.0 / 3), 1);
  EXPECT_NEAR(TangentSpread::meanSquareSine(1e-3), 2e-6, 1e-9) << "two axes of s each";
}

}  // namespace
}  // namespace loomlight
