#include "core/fabric/yarn/colour.h"

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

constexpr double kDarkest = 1e-4;

/// Chiang et al. 2016, Eq. 9: ln(colour) = -sqrt(absorption * radius) * this.
double depthFactor(double betaN) {
  const double b = betaN;
  return 5.969 + b * (-0.215 + b * (2.532 + b * (-10.73 + b * (5.574 + b * 0.245))));
}

double reflectanceOf(double absorption_per_mm, double factor, double radius_um) {
  const double depth = std::sqrt(std::max(0.0, absorption_per_mm) * radius_um * kMmPerUm);
  return std::max(kDarkest, std::exp(-depth * factor));
}

template <class F>
Rgb perChannel(const Rgb& value, F&& f) {
  return {f(value.x), f(value.y), f(value.z)};
}

}  // namespace

Rgb absorptionFromColour(const Rgb& colour, double azimuthalRoughness, double radius_um) {
  const double factor = depthFactor(azimuthalRoughness);
  return perChannel(colour, [&](float c) {
    const double root = std::log(std::clamp(static_cast<double>(c), kDarkest, 1.0)) / factor;
    return static_cast<float>(root * root / (radius_um * kMmPerUm));
  });
}

Rgb colourFromAbsorption(const Rgb& absorption_per_mm, double azimuthalRoughness, double radius_um) {
  const double factor = depthFactor(azimuthalRoughness);
  return perChannel(absorption_per_mm,
                    [&](float absorption) { return static_cast<float>(reflectanceOf(absorption, factor, radius_um)); });
}

Spectrum reflectanceFromAbsorption(const Spectrum& absorption_per_mm, double azimuthalRoughness, double radius_um) {
  const double factor = depthFactor(azimuthalRoughness);
  Spectrum reflectance;
  for (size_t j = 0; j < kBands; ++j)
    reflectance[j] = static_cast<float>(reflectanceOf(absorption_per_mm[j], factor, radius_um));
  return reflectance;
}

}  // namespace loomlight
