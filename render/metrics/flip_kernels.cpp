#include "render/metrics/flip_kernels.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace loomlight {
namespace {

/// a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees: what Johnson and Fairchild's contrast sensitivity is made of.
struct Sensitivity {
  double a, b;
};
// Table 1 of the paper.
constexpr Sensitivity kAchromatic{1, 0.0047}, kRedGreen{1, 0.0053}, kBlueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double kWidest = kBlueYellow[0].b;

constexpr double kPeakToTrough_deg = 0.082;  ///< of the eye's edge detectors; twice their standard deviation

template <class Weight>
std::vector<double> sampled(int radius, Weight&& weight) {
  std::vector<double> kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(weight(static_cast<double>(i)));
  return kernel;
}

double sum(const std::vector<double>& kernel) {
  double total = 0;
  for (const double w : kernel) total += w;
  return total;
}

Kernel normalised(const std::vector<double>& kernel) {
  const double total = sum(kernel);
  Kernel result;
  for (const double w : kernel) result.push_back(static_cast<float>(w / total));
  return result;
}

/// Positive weights sum to 1, negative to -1.
Kernel balanced(const std::vector<double>& kernel) {
  double positive = 0, negative = 0;
  for (const double w : kernel) (w > 0 ? positive : negative) += w;
  Kernel result;
  for (const double w : kernel) result.push_back(static_cast<float>(w > 0 ? w / positive : -w / negative));
  return result;
}

}  // namespace

FlipKernels::FlipKernels(double pixelsPerDegree) {
  const int sensitivityRadius = static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixelsPerDegree));
  const auto gaussian = [&](const Sensitivity& s) {
    return sampled(sensitivityRadius, [&](double i) {
      const double x_deg = i / pixelsPerDegree;
      return std::exp(-kPi * kPi * x_deg * x_deg / s.b);
    });
  };
  achromatic = normalised(gaussian(kAchromatic));
  redGreen = normalised(gaussian(kRedGreen));
  // The sum is normalised as a whole: each term keeps its share of the volume.
  double volume[2];
  for (int i = 0; i < 2; ++i) {
    const std::vector<double> kernel = gaussian(kBlueYellow[i]);
    blueYellow[i].kernel = normalised(kernel);
    volume[i] = kBlueYellow[i].a * std::sqrt(kPi / kBlueYellow[i].b) * sum(kernel) * sum(kernel);
  }
  for (int i = 0; i < 2; ++i) blueYellow[i].weight = static_cast<float>(volume[i] / (volume[0] + volume[1]));

  const double deviation = 0.5 * kPeakToTrough_deg * pixelsPerDegree, variance = deviation * deviation;
  const int featureRadius = static_cast<int>(std::ceil(3 * deviation));
  const auto bell = [&](double i) { return std::exp(-i * i / (2 * variance)); };
  smooth = normalised(sampled(featureRadius, bell));
  edge = balanced(sampled(featureRadius, [&](double i) { return -i * bell(i); }));
  point = balanced(sampled(featureRadius, [&](double i) { return (i * i / variance - 1) * bell(i); }));
  radius = std::max(sensitivityRadius, featureRadius);
}

}  // namespace loomlight
