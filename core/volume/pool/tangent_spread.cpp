#include "core/volume/pool/tangent_spread.h"

#include <vector>

// How it works. The mean over the turned tangents is a double integral: by the trapezoidal rule over the logarithm of
// the angle, by the midpoint rule over the turn, both of which converge exponentially. It is tabulated divided by what
// makes it smooth at its tip; the row of vanishing spread is its limit in the plane. The inverse, from a mean squared
// sine to a spread, is a table over the root, where it is nearly linear.

namespace loomlight {
namespace {

/// E f(theta) over the angle theta = s x by which an isotropic two-dimensional Gaussian turns; x has Rayleigh's density
/// x exp(-x^2 / 2). Over u = ln x the integrand vanishes smoothly at both ends, so the trapezoidal rule converges
/// exponentially.
template <class F>
double overAngle(double spread, int steps, const F& f) {
  const double low = -7, high = std::log(8.5);  // beyond: 4e-7 and 2e-16 of the whole
  const double h = (high - low) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double x = std::exp(low + i * h);
    sum += x * x * std::exp(-0.5 * x * x) * f(spread * x);
  }
  return sum * h;
}

/// Cosines of angles spread evenly over half a turn, the other half being alike. The integrands over a turn are smooth
/// and periodic, so the midpoint rule converges exponentially, except where a fibre lies along the ray.
std::vector<double> turnCosines(int steps) {
  std::vector<double> cosines(steps);
  for (int i = 0; i < steps; ++i) cosines[i] = std::cos(kPi * (i + 0.5) / steps);
  return cosines;
}

double integrate(double alpha, double spread, const std::vector<double>& turns) {
  if (spread <= 0) return std::abs(std::sin(alpha));
  return overAngle(spread, static_cast<int>(turns.size()), [&](double theta) {
    const double along = std::cos(alpha) * std::cos(theta), across = std::sin(alpha) * std::sin(theta);
    double sum = 0;
    for (const double turn : turns) {
      const double cosine = along + across * turn;
      sum += std::sqrt(std::max(0.0, 1 - cosine * cosine));
    }
    return sum / static_cast<double>(turns.size());
  });
}

/// What the row s = 0 tends to: the plane instead of the sphere, alpha = x s with s -> 0, divided by s (Rice's mean).
double planeLimit(double x, const std::vector<double>& turns) {
  return overAngle(1.0, static_cast<int>(turns.size()), [&](double theta) {
    double sum = 0;
    for (const double turn : turns) sum += std::sqrt(x * x + theta * theta + 2 * x * theta * turn);
    return sum / static_cast<double>(turns.size());
  });
}

}  // namespace

const TangentSpread& TangentSpread::table() {
  static const TangentSpread instance;
  return instance;
}

double TangentSpread::projectedLengthExact(double alpha_rad, double spread) {
  return integrate(alpha_rad, spread, turnCosines(400));
}

TangentSpread::TangentSpread() {
  const std::vector<double> turns =
      turnCosines(48);  // adds less than 1e-4 to the error of the table, which is made at once
  for (int j = 0; j < kSpreads; ++j) {
    const double s = static_cast<double>(j) / (kSpreads - 1), k = 2 * s * s;
    for (int i = 0; i < kRatios; ++i) {
      const double ratio = static_cast<double>(i) / (kRatios - 1);
      double value = 1;
      if (j == 0) {
        // sin^2 / (sin^2 + 2 s^2) = ratio at vanishing s.
        if (ratio < 1) value = planeLimit(std::sqrt(2 * ratio / (1 - ratio)), turns) * std::sqrt((1 - ratio) / 2);
      } else {
        const double sinSquare = std::min(1.0, k * ratio / (1 + k - ratio));
        value = integrate(std::asin(std::sqrt(sinSquare)), s, turns) / std::sqrt(sinSquare + k);
      }
      values_[j][i] = static_cast<float>(value);
    }
  }
}

double TangentSpread::meanSquareSine(double spread) {
  return overAngle(spread, 400, [](double theta) { return std::sin(theta) * std::sin(theta); });
}

Float64x4 TangentSpread::spreadsFromMeanSquareSines(Float64x4 meanSquares) {
  // Spread over root-mean-square sine, which is nearly linear: s = rms / sqrt(2) for small s.
  static constexpr int kSamples = 256;
  struct Inverse {
    std::array<double, kSamples + 1> spread{};
    double rmsOfOne = std::sqrt(TangentSpread::meanSquareSine(1));
    Inverse() {
      double before = 0;
      for (int i = 1, j = 1; j <= kSamples; ++j) {
        const double s = static_cast<double>(j) / kSamples, rms = std::sqrt(TangentSpread::meanSquareSine(s));
        for (; i < kSamples && rmsOfOne * i / kSamples <= rms; ++i)
          spread[i] = s - (rms - rmsOfOne * i / kSamples) / (rms - before) / kSamples;
        before = rms;
      }
      spread[kSamples] = 1;
    }
  };
  static const Inverse inverse;
  const Float64x4 x =
      least(squareRoot(most(meanSquares, Float64x4{})) * (kSamples / inverse.rmsOfOne), broadcast<Float64x4>(kSamples));
  const Int32x4 i = truncated(least(x, broadcast<Float64x4>(kSamples - 1)));
  const double* at = inverse.spread.data();
  const Float64x4 low{at[i[0]], at[i[1]], at[i[2]], at[i[3]]};
  const Float64x4 high{at[i[0] + 1], at[i[1] + 1], at[i[2] + 1], at[i[3] + 1]};
  return low + (x - __builtin_convertvector(i, Float64x4)) * (high - low);
}

}  // namespace loomlight
