#include "render/colour/nearest_colour.h"

#include <algorithm>

#include "render/colour/colour_space.h"

namespace loomlight {
namespace {

constexpr float kFirstFactor = 0.5f, kLastFactor = 1e-3f;  // factors less one
constexpr double kLightnessTolerance = 2;

/// Downhill by factors on one, two or all channels, which get finer where none leads further.
class ColourDescent {
 public:
  ColourDescent(const Rgb& wanted, const Rgb& darkest, const Rgb& lightest)
      : wanted_(labFromLinear(glm::dvec3(wanted))), darkest_(darkest), lightest_(lightest) {}

  void startFrom(const Rgb& colour) {
    Rgb here = glm::clamp(colour, darkest_, lightest_);
    double distance = distanceTo(here);
    for (float step = kFirstFactor; step > kLastFactor;)
      if (!improve(1 + step, here, distance) && !improve(1 / (1 + step), here, distance)) step *= 0.5f;
    if (distance >= distance_) return;
    distance_ = distance;
    nearest_ = here;
  }
  const Rgb& nearest() const { return nearest_; }

 private:
  double distanceTo(const Rgb& colour) const {
    return ciede2000(wanted_, labFromLinear(glm::dvec3(colour)), kLightnessTolerance);
  }
  bool improve(float factor, Rgb& here, double& distance) const {
    for (unsigned channels = 1; channels < 8; ++channels) {
      Rgb next = here;
      for (int c = 0; c < 3; ++c)
        if (channels >> c & 1) next[c] *= factor;
      next = glm::clamp(next, darkest_, lightest_);
      const double at = distanceTo(next);
      if (at >= distance) continue;
      here = next;
      distance = at;
      return true;
    }
    return false;
  }

  Lab wanted_;
  Rgb darkest_, lightest_;
  Rgb nearest_{0.0f};
  double distance_ = 1e9;
};

}  // namespace

Rgb nearestColour(const Rgb& wanted, const Rgb& darkest, const Rgb& lightest) {
  if (glm::clamp(wanted, darkest, lightest) == wanted) return wanted;
  ColourDescent descent(wanted, darkest, lightest);
  descent.startFrom(wanted);
  // The same hue, as light as it can be had: where cutting off has lost it there is no way back downhill.
  float brightness = 1;
  for (int c = 0; c < 3; ++c)
    if (wanted[c] > 0) brightness = std::min(brightness, lightest[c] / wanted[c]);
  descent.startFrom(wanted * brightness);
  return descent.nearest();
}

}  // namespace loomlight
