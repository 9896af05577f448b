#include "render/optics/longitudinal_lobes.h"

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

LongitudinalLobes::LongitudinalLobes(double roughness, double scaleTilt_rad)
    : tilted_(scaleTilt_rad != 0), table_(kRows + 2) {
  // The scales turn the mirror cone of each mode by a different multiple of their angle (Marschner et al. 2003).
  constexpr double shifts[4] = {-2, 1, 4, 0};
  // Variance by roughness (Chiang et al. 2016, Eq. 7), and of the other modes relative to R (Marschner et al. 2003).
  const double b = roughness;
  const double root = 0.726 * b + 0.812 * b * b + 3.7 * std::pow(b, 20);
  constexpr double relative[4] = {1, 0.25, 4, 4};
  for (size_t mode = 0; mode < kModes; ++mode) {
    const double tilt = shifts[mode] * scaleTilt_rad;
    tilt_[mode] = {static_cast<float>(std::sin(tilt)), static_cast<float>(std::cos(tilt))};
    const double v = relative[mode] * root * root;
    inverseVariance_[mode] = static_cast<float>(1 / v);
    inverseDeviation_[mode] = static_cast<float>(1 / std::sqrt(v));
    norm_[mode] = static_cast<float>(normOf(v));
    inverse_[mode].variance = static_cast<float>(v);
    if (mode < 3) {
      solve(mode, v);
    } else {
      for (Lanes& row : table_) row[3] = row[2];  // TRT and the residual have the same variance
    }
  }
  for (size_t mode = 0; mode < kModes; ++mode) {
    float bound = 0;
    // Between two rows a * cosine is at most the larger a times the larger cosine.
    for (size_t row = 1; row <= kRows; ++row) {
      const float x = static_cast<float>(row) / kRows;
      bound = std::max(bound, std::max(table_[row - 1][mode], table_[row][mode]) * x);
    }
    inverse_[mode].bound = bound;
  }
}

void LongitudinalLobes::solve(size_t mode, double variance) {
  // Continued over the poles everything is periodic and smooth, so that the trapezoidal rule converges exponentially
  // once its step is below the width of the lobe.
  const int nodes = std::clamp(static_cast<int>(2 * kPi / std::sqrt(variance)) / 2 * 2, 64, 512);
  const int half = nodes / 2;
  const double step = kPi / nodes;
  const auto theta = [&](int k) { return (k + 0.5) * step; };  // k < half: one side; a() is even
  const auto index = [](int k) { return static_cast<size_t>(k); };
  const double norm = normOf(variance);
  const auto weight = [&](int k) { return norm * step * std::cos(theta(k)) * std::cos(theta(k)); };
  const auto entry = [&](double o, int k) {
    return weight(k) * (kernel(o, theta(k), variance) + kernel(o, -theta(k), variance));
  };

  std::vector<double> matrix(index(half) * index(half)), a(index(half)), row(index(half));
  for (int j = 0; j < half; ++j) {
    a[index(j)] = 1 / std::sqrt(std::cos(theta(j)));  // the solution for narrow lobes, away from the poles
    for (int k = 0; k < half; ++k) matrix[index(j * half + k)] = entry(theta(j), k);
  }
  for (int iteration = 0; iteration < 200; ++iteration) {
    double worst = 0;
    for (int j = 0; j < half; ++j) {
      double sum = 0;
      for (int k = 0; k < half; ++k) sum += matrix[index(j * half + k)] * a[index(k)];
      row[index(j)] = sum;
      worst = std::max(worst, std::abs(a[index(j)] * sum - 1));
    }
    for (int j = 0; j < half; ++j) a[index(j)] = std::sqrt(a[index(j)] / row[index(j)]);
    if (worst < 1e-8) break;
  }
  // The equation itself continues the solution from the nodes to any angle.
  for (size_t r = 0; r <= kRows; ++r) {
    const double x = static_cast<double>(r) / kRows;
    const double o = std::acos(x);
    double sum = 0;
    for (int k = 0; k < half; ++k) sum += entry(o, k) * a[index(k)];
    table_[r][mode] = static_cast<float>(1 / sum);
  }
  table_[kRows + 1][mode] = table_[kRows][mode];
}

}  // namespace loomlight::optics
