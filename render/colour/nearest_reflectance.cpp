#include "render/colour/nearest_reflectance.h"

#include <algorithm>
#include <cmath>

#include "render/colour/colour_difference.h"

// How it works. Of all reflectances between two that have the same X, Y and Z, the one that strays least from what is
// wanted (by relative entropy, each band counted by how much of its light the eye sees) is the wanted one times
// exp(a x + b y + c z), cut off where it cannot be had: x, y and z are the chromaticity of each band, and a, b and c
// Lagrange's multipliers. So three numbers reach every colour that can be had, by factors as smooth as the eye's
// response is, and with all of them 0 the reflectance is what is wanted, cut off. Downhill goes among these three.
//
// The very brightest of a hue are reflectances of nothing but lightest and darkest bands, which look otherwise under
// every other lamp: a little that nobody sees is given away for smooth ones.

namespace loomlight {
namespace {

using Multipliers = std::array<double, 3>;

constexpr double kFirstStep = 0.5, kLastStep = 1e-3, kLargestStep = 4;  // of the logarithm of a reflectance
constexpr int kMostSteps = 400;
constexpr double kUneven = 0.02;  // of CIEDE2000: what it is worth that multipliers differ by one less
constexpr float kBlack = 1e-4f;   // a reflectance of 0 has no logarithm

class ReflectanceDescent {
 public:
  ReflectanceDescent(const Spectrum& wanted, const Spectrum& darkest, const Spectrum& lightest,
                     const TristimulusWeights& weights)
      : wanted_(wanted),
        darkest_(darkest),
        lightest_(lightest),
        weights_(weights),
        standard_(labUnder(weights, wanted)) {
    for (size_t j = 0; j < kBands; ++j) {
      const float seen = weights.rows[0][j] + weights.rows[1][j] + weights.rows[2][j];
      for (size_t k = 0; k < 3; ++k) chromaticity_[k][j] = seen > 0 ? weights.rows[k][j] / seen : 1.0f / 3;
    }
  }

  void startFrom(Multipliers here) {
    double distance = distanceTo(here), step = kFirstStep;
    for (int i = 0; i < kMostSteps && step > kLastStep; ++i)
      step = improve(step, here, distance) ? std::min(2 * step, kLargestStep) : step / 2;
    if (distance >= distance_) return;
    distance_ = distance;
    nearest_ = here;
  }
  Spectrum nearest() const { return at(nearest_); }

 private:
  Spectrum at(const Multipliers& m) const {
    Spectrum reflectance;
    for (size_t j = 0; j < kBands; ++j) {
      const double exponent = m[0] * chromaticity_[0][j] + m[1] * chromaticity_[1][j] + m[2] * chromaticity_[2][j];
      const float free =
          exponent == 0 ? wanted_[j] : std::max(wanted_[j], kBlack) * std::exp(static_cast<float>(exponent));
      reflectance[j] = std::clamp(free, darkest_[j], lightest_[j]);
    }
    return reflectance;
  }
  double distanceTo(const Multipliers& m) const {
    const double mean = (m[0] + m[1] + m[2]) / 3;
    double uneven = 0;
    for (const double multiplier : m) uneven += (multiplier - mean) * (multiplier - mean);
    return ciede2000(standard_, labUnder(weights_, at(m))) + kUneven * uneven;
  }
  /// To the best of all neighbours, along the axes and between them.
  bool improve(double step, Multipliers& here, double& distance) const {
    Multipliers best = here;
    double least = distance;
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const int along[] = {neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1};
      const Multipliers next{here[0] + step * along[0], here[1] + step * along[1], here[2] + step * along[2]};
      const double at = distanceTo(next);
      if (at >= least) continue;
      least = at;
      best = next;
    }
    if (least >= distance) return false;
    here = best;
    distance = least;
    return true;
  }

  const Spectrum &wanted_, &darkest_, &lightest_;
  const TristimulusWeights& weights_;
  Lab standard_;
  std::array<Spectrum, 3> chromaticity_;
  Multipliers nearest_{};
  double distance_ = 1e9;
};

}  // namespace

Spectrum nearestReflectance(const Spectrum& wanted, const Spectrum& darkest, const Spectrum& lightest,
                            const TristimulusWeights& weights) {
  double brightness = 0;
  bool isReached = true;
  for (size_t j = 0; j < kBands; ++j) {
    isReached &= darkest[j] <= wanted[j] && wanted[j] <= lightest[j];
    if (wanted[j] > lightest[j]) brightness = std::min(brightness, std::log(double{lightest[j]} / wanted[j]));
  }
  if (isReached) return wanted;
  ReflectanceDescent descent(wanted, darkest, lightest, weights);
  descent.startFrom({});
  if (brightness < 0) descent.startFrom({brightness, brightness, brightness});
  return descent.nearest();
}

}  // namespace loomlight
