#include "core/volume/tangent_spread.h"

namespace loomlight {
namespace {

/// E f(theta) over the angle by which an isotropic two-dimensional Gaussian turns: Rayleigh of scale s. Substituting
/// theta = s sqrt(-2 ln u) would leave a singular end; theta itself, up to 8.5 s, leaves nothing but a smooth integrand
/// that vanishes at both ends, which the trapezoidal rule integrates with exponential accuracy.
template <class F>
double overAngle(double spread, int steps, const F& f) {
  const double reach = 8.5;
  double sum = 0;
  for (int i = 1; i < steps; ++i) {
    const double x = reach * i / steps;
    sum += x * std::exp(-0.5 * x * x) * f(spread * x);
  }
  return sum * reach / steps;
}

/// E |sin angle(d, t)| where t is `theta` from m, uniformly around it, and m is alpha from d. The angle runs over one
/// period of a smooth function, so the midpoint rule converges exponentially except where t passes through d.
double overTurn(double alpha, double theta, int steps) {
  const double along = std::cos(alpha) * std::cos(theta), across = std::sin(alpha) * std::sin(theta);
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = along + across * std::cos(kPi * (i + 0.5) / steps);
    sum += std::sqrt(std::max(0.0, 1 - cosine * cosine));
  }
  return sum / steps;
}

double integrate(double alpha, double spread, int steps) {
  if (spread <= 0) return std::abs(std::sin(alpha));
  return overAngle(spread, steps, [&](double theta) { return overTurn(alpha, theta, steps); });
}

/// What the row s = 0 tends to: the plane instead of the sphere, alpha = x s with s -> 0, divided by s (Rice's mean).
double planeLimit(double x, int steps) {
  return overAngle(1.0, steps, [&](double theta) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double turn = kPi * (i + 0.5) / steps;
      sum += std::sqrt(x * x + theta * theta + 2 * x * theta * std::cos(turn));
    }
    return sum / steps;
  });
}

}  // namespace

const TangentSpread& TangentSpread::table() {
  static const TangentSpread instance;
  return instance;
}

double TangentSpread::projectedLengthExact(double alpha_rad, double spread) {
  return integrate(alpha_rad, spread, 400);
}

TangentSpread::TangentSpread() {
  constexpr int kSteps = 96;  // within 1e-4 of the integral, in a few tens of milliseconds for the whole table
  for (int j = 0; j < kSpreads; ++j) {
    const double s = static_cast<double>(j) / (kSpreads - 1), k = 2 * s * s;
    for (int i = 0; i < kRatios; ++i) {
      const double ratio = static_cast<double>(i) / (kRatios - 1);
      double value = 1;
      if (j == 0) {
        // sin^2 / (sin^2 + 2 s^2) = ratio at vanishing s.
        if (ratio < 1) value = planeLimit(std::sqrt(2 * ratio / (1 - ratio)), kSteps) * std::sqrt((1 - ratio) / 2);
      } else {
        const double sinSquare = std::min(1.0, k * ratio / (1 + k - ratio));
        value = integrate(std::asin(std::sqrt(sinSquare)), s, kSteps) / std::sqrt(sinSquare + k);
      }
      values_[j][i] = static_cast<float>(value);
    }
  }
}

double TangentSpread::meanSquareSine(double spread) {
  return overAngle(spread, 400, [](double theta) { return std::sin(theta) * std::sin(theta); });
}

double TangentSpread::spreadFromMeanSquareSine(double meanSquare) {
  // Spread over root-mean-square sine, which is nearly linear: s = rms / sqrt(2) for small s.
  static constexpr int kSamples = 256;
  struct Inverse {
    std::array<double, kSamples + 1> spread;
    double rmsLast = std::sqrt(TangentSpread::meanSquareSine(1));
    Inverse() {
      for (int i = 0; i <= kSamples; ++i) {
        const double rms = rmsLast * i / kSamples;
        double low = 0, high = 1;
        while (high - low > 1e-10) {
          const double middle = 0.5 * (low + high);
          (std::sqrt(TangentSpread::meanSquareSine(middle)) < rms ? low : high) = middle;
        }
        spread[i] = i == 0 ? 0 : 0.5 * (low + high);
      }
    }
  };
  static const Inverse inverse;
  const double x = std::sqrt(std::max(0.0, meanSquare)) / inverse.rmsLast * kSamples;
  if (!(x < kSamples)) return 1;
  const int i = static_cast<int>(x);
  return inverse.spread[i] + (x - i) * (inverse.spread[i + 1] - inverse.spread[i]);
}

glm::vec3 sampleTangent(const FibreDistribution& distribution, float u1, float u2) {
  const glm::vec3 m = distribution.direction;
  if (distribution.spread == 0) return m;
  const float theta = distribution.spread * std::sqrt(-2 * std::log1p(-u1));
  const float phi = static_cast<float>(2 * kPi) * u2;
  // Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
  const float sign = std::copysign(1.0f, m.z);
  const float a = -1 / (sign + m.z), b = m.x * m.y * a;
  const glm::vec3 e1(1 + sign * m.x * m.x * a, sign * b, -sign * m.x), e2(b, sign + m.y * m.y * a, -m.y);
  const float across = std::sin(theta);
  return std::cos(theta) * m + across * (std::cos(phi) * e1 + std::sin(phi) * e2);
}

}  // namespace loomlight
