#include "render/optics/azimuthal_lobes.h"

namespace loomlight::optics {
namespace {

/// Scale of the logistic for a roughness in [0, 1], chosen by its authors to look even (Chiang et al. 2016, Eq. 8).
double logisticScale(double roughness) {
  const double b = roughness;
  return 0.626657069 * (0.265 * b + 1.194 * b * b + 5.372 * std::pow(b, 22));
}

}  // namespace

double AzimuthalLobes::normalDeviation(FibreSection section) {
  // Of the outline radius = 1 + a cos(n t) the normal deviates by n a sin(n t), so by n a / sqrt(2) in the mean square.
  const auto wave = [](double n, double a) { return n * a / std::sqrt(2.0); };
  switch (section) {
    case FibreSection::round:
      return 0;
    case FibreSection::kidney:
      return wave(2, 0.22);  // an oval 1.55 times as long as wide
    case FibreSection::triangle:
      return wave(3, 0.10);  // silk: corners well rounded
    case FibreSection::trilobal:
      return wave(3, 0.20);  // modification ratio 1.5
    case FibreSection::serrated:
      return wave(8, 0.05);  // viscose: many shallow lobes
    case FibreSection::polygon:
      return kPi / 6 / std::sqrt(3.0);  // six flats: uniform within 30 degrees
  }
  return 0;
}

AzimuthalLobes::AzimuthalLobes(double roughness, FibreSection section, double index) {
  const double deviation = normalDeviation(section);
  const double outside = 2 * deviation, inside = 2 * index * deviation, refraction = (index - 1) * deviation;
  const double variance[3] = {outside * outside, 2 * refraction * refraction,
                              2 * refraction * refraction + inside * inside};
  const double rough = logisticScale(roughness);
  for (size_t mode = 0; mode < 3; ++mode) {
    // The variance of a logistic distribution is (pi scale)^2 / 3.
    const double scale = std::sqrt(rough * rough + 3 * variance[mode] / (kPi * kPi));
    const double reach = std::tanh(0.5 * kPi / scale);
    inverseScale_[mode] = static_cast<float>(1 / scale);
    norm_[mode] = static_cast<float>(1 / (scale * reach));
    scale_[mode] = static_cast<float>(scale / kPi);
    reach_[mode] = static_cast<float>(reach);
  }
}

}  // namespace loomlight::optics
