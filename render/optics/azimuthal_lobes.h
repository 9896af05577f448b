#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random_lanes.h"
#include "core/base/units.h"
#include "core/fabric/model/fabric.h"
#include "render/optics/dielectric_cylinder.h"
#include "render/optics/polynomials.h"

namespace loomlight::optics {

/// Scattering about the fibre: a logistic distribution, trimmed to [-pi, pi], around the turn that a smooth cylinder
/// would give each mode (Chiang et al. 2016); the residual goes everywhere alike.
///
/// A section that is not round turns the normal by some angle d away from the radius, a different one at every bounce.
/// To first order that turns a reflection from outside by 2d, one from inside by 2 eta d, a refraction by (eta - 1) d.
/// A fibre in cloth lies at any angle about its own axis, so these turns are random and their variance is added to that
/// of the surface roughness; what the fibre reflects or lets through in all is not touched.
class AzimuthalLobes {
 public:
  AzimuthalLobes(double roughness, FibreSection section, double index);

  /// Density over the azimuth of wi relative to wo for every mode; of its cosine and sine only the ratio counts.
  template <class T>
  ModesOf<T> density(const CylinderHit<T>& hit, T cosine, T sine) const {
    ModesOf<T> result;
    for (size_t mode = 0; mode < 3; ++mode) {
      const T c = cosine * hit.turnCosine[mode] - sine * hit.turnSine[mode];
      const T s = cosine * hit.turnSine[mode] + sine * hit.turnCosine[mode];
      const T decay = exponential<T>(-angle(s, c) * inverseScale_[mode]), root = 1 + decay;
      result[mode] = norm_[mode] * decay / (root * root);
    }
    result[3] = broadcast<T>(1 / (2 * kPi));
    return result;
  }

  /// Azimuth of wi relative to wo; mode 0 to 3.
  template <class T>
  SinCos<T> sample(WholeOf<T> mode, const CylinderHit<T>& hit, RandomLanes<T>& random) const {
    const T u = 2 * random.uniform() - 1;
    const T scale = chosen<T>(mode, scale_), reach = chosen<T>(mode, reach_);
    const T w = u * reach;
    const T x = most(broadcast<T>(-1.0), least(scale * logarithm<T>((1 + w) / (1 - w)), broadcast<T>(1.0)));
    const auto isUniform = mode == 3;
    const SinCos<T> deviation = sinCosPi<T>(isUniform ? u : x);
    const T c = chosen<T>(mode, hit.turnCosine), s = -chosen<T>(mode, hit.turnSine);
    const T sine = c * deviation.sine + s * deviation.cosine, cosine = c * deviation.cosine - s * deviation.sine;
    return {isUniform ? deviation.sine : sine, isUniform ? deviation.cosine : cosine};
  }

  /// Standard deviation of the angle between normal and radius, over the outline; radians.
  static double normalDeviation(FibreSection section);

 private:
  ModesOf<float> inverseScale_{}, norm_{};  ///< the residual is uniform, and has none
  ModesOf<float> scale_{};                  ///< of the logistic, in units of pi
  ModesOf<float> reach_{};                  ///< twice the probability between the centre and pi before trimming
};

}  // namespace loomlight::optics
