#include "render/optics/longitudinal_lobes.h"

#include <numeric>

#include "render/optics/dielectric_cylinder.h"

namespace loomlight::optics {
namespace {

/// e^-x I0(x), by its power series or, for large x, its asymptotic one (Abramowitz & Stegun 9.6.12, 9.7.1).
double scaledBesselI0(double x) {
  if (x > 30) {
    double term = 1, sum = 1;
    for (int k = 1; k <= 8; ++k) sum += term *= (2 * k - 1) * (2 * k - 1) / (8 * k * x);
    return sum / std::sqrt(2 * kPi * x);
  }
  double term = 1, sum = 1;
  const double q = 0.25 * x * x;
  for (int k = 1; term > sum * 1e-16; ++k) sum += term *= q / (static_cast<double>(k) * k);
  return sum * std::exp(-x);
}

/// Shares of the modes, averaged over the offset h, by the midpoint rule in its arcsine: periodic and smooth.
Lanes meanShare(double cosine, double index) {
  constexpr int kPoints = 24;
  const glm::vec3 wo(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine, 0.0);
  Lanes sum{};
  float weights = 0;
  for (int k = 0; k < kPoints; ++k) {
    const double gamma = 0.5 * kPi * (k + 0.5) / kPoints;
    const auto weight = static_cast<float>(std::cos(gamma));
    sum += weight * CylinderHit(wo, static_cast<float>(std::sin(gamma)), static_cast<float>(index)).share;
    weights += weight;
  }
  return sum / weights;
}

double normOf(double v) {
  return 1 / (v * -std::expm1(-2 / v));
}

/// M(o, i) without its norm.
double kernel(double o, double i, double v) {
  const double half = std::sin(0.5 * (o + i));
  const double exponent = -2 * half * half / v;
  return exponent < -45 ? 0.0 : std::exp(exponent) * scaledBesselI0(std::cos(o) * std::cos(i) / v);
}

}  // namespace

LongitudinalLobes::LongitudinalLobes(double roughness, double index, double scaleTilt_rad)
    : tilted_(scaleTilt_rad != 0), outgoing_(kRows + 2), incoming_(kRows + 2) {
  // The scales turn the mirror cone of each mode by a different multiple of their angle (Marschner et al. 2003).
  constexpr double shifts[kModes] = {-2, 1, 4, 0};
  // Variance by roughness (Chiang et al. 2016, Eq. 7), and of the other modes relative to R (Marschner et al. 2003).
  const double b = roughness;
  const double root = 0.726 * b + 0.812 * b * b + 3.7 * std::pow(b, 20);
  constexpr double relative[kModes] = {1, 0.25, 4, 4};
  for (size_t mode = 0; mode < kModes; ++mode) {
    const double tilt = shifts[mode] * scaleTilt_rad;
    tilt_[mode] = {static_cast<float>(std::sin(tilt)), static_cast<float>(std::cos(tilt))};
    const double v = relative[mode] * root * root;
    inverseVariance_[mode] = static_cast<float>(1 / v);
    inverseDeviation_[mode] = static_cast<float>(1 / std::sqrt(v));
    norm_[mode] = static_cast<float>(normOf(v));
    solve(mode, v, index);
    inverse_[mode].variance = static_cast<float>(v);
    for (size_t row = 1; row <= kRows; ++row) {
      // Between two rows a * cosine is at most the larger a times the larger cosine.
      const float largest = std::max(incoming_[row - 1][mode], incoming_[row][mode]);
      inverse_[mode].bound = std::max(inverse_[mode].bound, largest * static_cast<float>(row) / kRows);
    }
  }
}

void LongitudinalLobes::solve(size_t mode, double variance, double index) {
  // Continued over the poles M is periodic and smooth, so that the trapezoidal rule converges exponentially once its
  // step is below the width of the lobe. a() is even: only one side of the plane is solved for.
  const size_t half = static_cast<size_t>(std::clamp(kPi / std::sqrt(variance), 32.0, 256.0));
  const double step = 0.5 * kPi / static_cast<double>(half);
  std::vector<double> theta(half), weight(half), share(half), a(half), row(half), matrix(half * half);
  for (size_t k = 0; k < half; ++k) {
    theta[k] = (static_cast<double>(k) + 0.5) * step;
    const double cosine = std::cos(theta[k]);
    weight[k] = normOf(variance) * step * cosine * cosine;
    share[k] = meanShare(cosine, index)[mode];
    a[k] = std::sqrt(share[k] / cosine);  // the solution for narrow lobes, away from the poles
  }
  const auto entry = [&](double o, size_t k) {
    return weight[k] * (kernel(o, theta[k], variance) + kernel(o, -theta[k], variance));
  };
  for (size_t j = 0; j < half; ++j) {
    for (size_t k = 0; k < half; ++k) matrix[j * half + k] = entry(theta[j], k);
  }
  double worst = 1;
  for (int iteration = 0; iteration < 200 && worst > 1e-8; ++iteration) {
    for (size_t j = 0; j < half; ++j) row[j] = std::inner_product(a.begin(), a.end(), &matrix[j * half], 0.0);
    worst = 0;
    for (size_t j = 0; j < half; ++j) {
      worst = std::max(worst, std::abs(a[j] * row[j] / share[j] - 1));
      a[j] = std::sqrt(a[j] * share[j] / row[j]);
    }
  }
  // The equation itself continues the solution from the nodes to any angle.
  for (size_t r = 0; r <= kRows; ++r) {
    const double cosine = static_cast<double>(r) / kRows, o = std::acos(cosine);
    double sum = 0;
    for (size_t k = 0; k < half; ++k) sum += entry(o, k) * a[k];
    outgoing_[r][mode] = static_cast<float>(1 / sum);
    incoming_[r][mode] = static_cast<float>(meanShare(cosine, index)[mode] / sum);
  }
  outgoing_[kRows + 1] = outgoing_[kRows];
  incoming_[kRows + 1] = incoming_[kRows];
}

}  // namespace loomlight::optics
