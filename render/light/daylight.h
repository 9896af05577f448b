#pragma once

#include "core/base/units.h"

namespace loomlight {

/// The daylight of Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight" (SIGGRAPH 1999): the clear
/// sky, the attenuated sun, and a grey ground below the horizon that both light. Radiances are scaled, channel by
/// channel, so that white paper on the ground has radiance (1, 1, 1) with turbidity 3 and the sun 45 degrees high: a
/// fixed exposure and white balance, so that other hours and hazes keep their colour.
///
/// The model knows no sun below the horizon; there the sky of sunset fades to night, dark at -6 degrees, the end of
/// civil twilight, and the sun is gone.
class Daylight {
 public:
  /// Any turbidity and elevation; turbidity is clamped to the model's 2..10.
  Daylight(double turbidity, double azimuth_deg, double elevation_deg);

  /// Sky above the horizon, ground below it; without the sun's disc.
  Rgb radiance(glm::vec3 d) const;

  // The sun's disc, of even brightness; zero below the horizon.
  static constexpr double sunHalfAngle_deg = 0.265;
  glm::vec3 sunDirection() const { return sunDirection_; }
  Rgb sunRadiance() const { return sunRadiance_; }

 private:
  /// Perez et al. 1993: (1 + A e^(B / cos theta)) (1 + C e^(D gamma) + E cos^2 gamma), for Y, x and y at once.
  glm::vec3 perez(float cosTheta, float gamma, float cosGamma) const;
  Rgb sky(glm::vec3 d) const;

  glm::vec3 a_, b_, c_, d_, e_;  ///< of Y, x, y
  glm::vec3 scale_;              ///< zenith over the Perez function at the zenith
  glm::vec3 sunDirection_;       ///< where the sun is
  glm::vec3 glowDirection_;      ///< where the sky believes it is: not below the horizon
  Rgb sunRadiance_{0}, groundRadiance_{0};
};

}  // namespace loomlight
