#include "app/export/handover/least_squares.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace loomlight {
namespace {

/// a exp(-b t) + c at 40 places.
std::vector<double> decay(std::span<const double> at) {
  std::vector<double> values;
  for (int i = 0; i < 40; ++i) values.push_back(at[0] * std::exp(-at[1] * 0.1 * i) + at[2]);
  return values;
}

std::vector<double> minus(std::vector<double> a, const std::vector<double>& b) {
  for (size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

TEST(LeastSquares, FindsTheNumbersThatACurveWasMadeOf) {
  const std::vector<double> wanted = decay(std::array{2.0, 1.3, 0.25});
  const std::array unknowns{Unknown{1, 0, 10}, Unknown{0.3, 0, 10}, Unknown{0, -1, 1}};
  const LeastSquares fit = leastSquares(unknowns, [&](std::span<const double> at) { return minus(decay(at), wanted); });
  EXPECT_NEAR(fit.values[0], 2.0, 1e-4);
  EXPECT_NEAR(fit.values[1], 1.3, 1e-4);
  EXPECT_NEAR(fit.values[2], 0.25, 1e-4);
  EXPECT_LT(fit.sum, 1e-8);
}

TEST(LeastSquares, StopsAtItsBoundsAndFitsTheRest) {
  const std::vector<double> wanted = decay(std::array{2.0, 1.3, 0.25});
  const std::array unknowns{Unknown{1, 0, 10}, Unknown{0.3, 0, 10}, Unknown{0, -1, 0.1}};
  const LeastSquares fit = leastSquares(unknowns, [&](std::span<const double> at) { return minus(decay(at), wanted); });
  EXPECT_EQ(fit.values[2], 0.1);
  // The best with c held there, by the fit of the other two alone.
  const std::array others{Unknown{1, 0, 10}, Unknown{0.3, 0, 10}};
  const LeastSquares held = leastSquares(
      others, [&](std::span<const double> at) { return minus(decay(std::array{at[0], at[1], 0.1}), wanted); });
  EXPECT_NEAR(fit.values[0], held.values[0], 1e-3);
  EXPECT_NEAR(fit.values[1], held.values[1], 1e-3);
}

TEST(LeastSquares, AnUnknownThatDoesNotMatterStaysWhereItIs) {
  const std::array unknowns{Unknown{0.5, 0, 1}, Unknown{0.7, 0, 1}};
  const LeastSquares fit =
      leastSquares(unknowns, [](std::span<const double> at) { return std::vector{at[0] - 0.25, 0.0}; });
  EXPECT_NEAR(fit.values[0], 0.25, 1e-6);
  EXPECT_NEAR(fit.values[1], 0.7, 1e-6);
}

}  // namespace
}  // namespace loomlight
