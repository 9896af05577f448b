#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/volume/pool/component.h"

namespace loomlight {

/// I(alpha, s) = E |sin angle(d, t)|: the mean projected length of a unit fibre seen along d, where the tangent t is
/// the mean direction m turned by a two-dimensional isotropic Gaussian angle of s radians per axis, and alpha is the
/// angle between d and m. With it, sigma(d) = 2 r lambda I (Eqs. 6-7 of the report, with the spread it has in three
/// dimensions).
///
/// I has a cone's tip at alpha = s = 0, where no table over (alpha, s) is any good. What is tabulated is the smooth
/// I / sqrt(sin^2 alpha + 2 s^2), over s and over a ratio of alpha to s; `projectedLength` is a square root, a division
/// and one bilinear look-up.
class TangentSpread {
 public:
  static const TangentSpread& table();

  /// sinAlpha in [0, 1], spread in [0, 1]. Within 0.1 % of the integral; never above 1.
  float projectedLength(float sinAlpha, float spread) const {
    return projectedLengthOfSquare(sinAlpha * sinAlpha, spread);
  }
  /// The same from sin^2 alpha, which is what a dot product gives.
  float projectedLengthOfSquare(float sinSquareAlpha, float spread) const;
  /// The integral itself, by quadrature: what the table is built from and tested against.
  static double projectedLengthExact(double alpha_rad, double spread);

  /// E[sin^2 angle(m, t)] of a spread, by quadrature.
  static double meanSquareSine(double spread);
  /// The spread s whose Gaussian has this E[sin^2 angle(m, t)], 0..2/3 and clamped to s <= 1.
  static double spreadFromMeanSquareSine(double meanSquareSine) {
    return spreadsFromMeanSquareSines(broadcast<Float64x4>(meanSquareSine))[0];
  }
  static Float64x4 spreadsFromMeanSquareSines(Float64x4 meanSquareSines);

  /// The table itself, for those who look up many numbers side by side (render/walk).
  struct View {
    const float* values;  ///< [spreads][ratios]
    int ratios, spreads;
  };
  View view() const { return {values_[0], kRatios, kSpreads}; }

 private:
  TangentSpread();
  static constexpr int kRatios = 64, kSpreads = 32;
  float values_[kSpreads][kRatios];
};

inline float TangentSpread::projectedLengthOfSquare(float sinSquareAlpha, float spread) const {
  const float k = 2 * spread * spread;
  const float sum = sinSquareAlpha + k;
  if (sum <= 0) return 0;
  const float x = sinSquareAlpha * (1 + k) / sum * (kRatios - 1);
  const float y = spread * (kSpreads - 1);
  const int i = std::min(static_cast<int>(x), kRatios - 2);
  const int j = std::min(static_cast<int>(y), kSpreads - 2);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const float* low = values_[j] + i;
  const float* high = values_[j + 1] + i;
  const float a = low[0] + fx * (low[1] - low[0]);
  const float b = high[0] + fx * (high[1] - high[0]);
  return std::min(1.0f, std::sqrt(sum) * (a + fy * (b - a)));
}

}  // namespace loomlight
