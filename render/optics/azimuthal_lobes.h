#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random.h"
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
  Float32x4 density(const CylinderHit<float>& hit, float cosine, float sine) const {
    return logistic(cosine, sine, sideBySide(hit.turnCosine), sideBySide(hit.turnSine), inverseScale_, norm_);
  }
  /// The same for one mode, at several offsets side by side.
  Float32x4 density(size_t mode, const CylinderHit<Float32x4>& hit, float cosine, float sine) const {
    return mode == 3 ? broadcast<Float32x4>(0.25f * norm_[3])
                     : logistic(cosine, sine, hit.turnCosine[mode], hit.turnSine[mode],
                                broadcast<Float32x4>(inverseScale_[mode]), broadcast<Float32x4>(norm_[mode]));
  }

  /// Azimuth of wi relative to wo; mode 0 to 3.
  SinCos sample(size_t mode, const CylinderHit<float>& hit, Random& random) const {
    const float u = 2 * random.uniform() - 1;
    const Inverse& inverse = inverse_[mode];
    if (inverse.scale == 0) return sinCosPi(u);
    const float w = u * inverse.reach;
    const float x = std::clamp(inverse.scale * logarithm((1 + w) / (1 - w)), -1.0f, 1.0f);
    const SinCos deviation = sinCosPi(x);
    const float c = hit.turnCosine[mode], s = -hit.turnSine[mode];
    return {c * deviation.sine + s * deviation.cosine, c * deviation.cosine - s * deviation.sine};
  }

  /// Standard deviation of the angle between normal and radius, over the outline; radians.
  static double normalDeviation(FibreSection section);

 private:
  static Float32x4 logistic(float cosine, float sine, Float32x4 turnCosine, Float32x4 turnSine, Float32x4 inverseScale,
                            Float32x4 norm) {
    const Float32x4 c = cosine * turnCosine - sine * turnSine;
    const Float32x4 s = cosine * turnSine + sine * turnCosine;
    const Float32x4 decay = exponential(-angle(s, c) * inverseScale);
    const Float32x4 root = 1 + decay;
    return norm * decay / (root * root);
  }

  struct Inverse {
    float scale = 0;  ///< of the logistic, in units of pi; 0: uniform
    float reach = 0;  ///< twice the probability between the centre and pi before trimming
  };
  Float32x4 inverseScale_{}, norm_{};
  std::array<Inverse, 4> inverse_{};
};

}  // namespace loomlight::optics
