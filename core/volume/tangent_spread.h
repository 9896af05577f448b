#pragma once

#include "core/base/units.h"

namespace loomlight {

/// I(alpha, s) = E |sin angle(d, t)|: the mean projected length of a unit fibre seen along d, where the tangent t is
/// the mean direction m turned by a two-dimensional isotropic Gaussian angle of s radians per axis, and alpha is the
/// angle between d and m. With it, sigma(d) = 2 r lambda I (Eqs. 6-7 of the report, with the spread it has in three
/// dimensions). Tabulated over sin(alpha) and s; `projectedLength` is one bilinear look-up.
class TangentSpread {
 public:
  static const TangentSpread& table();

  /// sinAlpha in [0, 1], spread in [0, 1]. Within 0.2 % of the integral.
  float projectedLength(float sinAlpha, float spread) const;
  /// The integral itself, by quadrature: what the table is built from and tested against.
  static double projectedLengthExact(double alpha_rad, double spread);
  /// The spread s whose Gaussian has this E[sin^2 angle(m, t)], 0..2/3 and clamped to s <= 1.
  static double spreadFromMeanSquareSine(double meanSquareSine);

 private:
  TangentSpread();
  static constexpr int kSines = 64, kSpreads = 32;
  float values_[kSpreads][kSines];
};

}  // namespace loomlight
