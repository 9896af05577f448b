#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/base/units.h"
#include "render/optics/lanes.h"

namespace loomlight::optics {

/// An inclination to the plane across the fibre; the cosine lies in [0, 1].
struct Inclination {
  float sine, cosine;
  float root;  ///< of the cosine

  Inclination(float sine, float cosine) : sine(sine), cosine(cosine), root(std::sqrt(cosine)) {}
};

/// Scattering along the fibre. d'Eon et al. 2011 give the density of the inclination i of wi, for a lobe of variance v
/// around the mirror cone,
///   M(o, i) = exp(-sin_o sin_i / v) I0(cos_o cos_i / v) / (2 v sinh(1 / v)),   integral of M cos_i di = 1:
/// energy is kept for light that leaves along o, but light that arrives along i is multiplied, several times at grazing
/// angles. Sinkhorn's scaling of rows and columns repairs that: with the one function a() that solves
///   a(o) * integral of a(i) M(o, i) cos_i^2 di = 1
/// the lobe S = a(o) a(i) M(o, i) is symmetric, and S cos_i integrates to one from either side.
class LongitudinalLobes {
 public:
  LongitudinalLobes(double roughness, double scaleTilt_rad);

  /// Where wo lies, as every mode sees it: shifted by the tilt of the scales.
  struct Outgoing {
    Lanes sine, cosine, root, a;
  };
  Outgoing outgoing(Inclination o) const {
    if (!tilted_) return {spread(o.sine), spread(o.cosine), spread(o.root), correction(o)};
    Outgoing shifted;
    for (size_t mode = 0; mode < kModes; ++mode) {
      const float sine = o.sine * tilt_[mode].cosine + o.cosine * tilt_[mode].sine;
      const Inclination s(sine, std::abs(o.cosine * tilt_[mode].cosine - o.sine * tilt_[mode].sine));
      shifted.sine[mode] = s.sine;
      shifted.cosine[mode] = s.cosine;
      shifted.root[mode] = s.root;
      shifted.a[mode] = correction(mode, s);
    }
    return shifted;
  }

  /// S cos_i for every mode.
  Lanes density(const Outgoing& o, Inclination i) const {
    // 1 - cos(o + i) as half a squared distance: narrow lobes would not survive the difference.
    const Lanes sines = o.sine + i.sine, cosines = o.cosine - i.cosine;
    const Lanes versine = 0.5f * (sines * sines + cosines * cosines);
    const BesselI0 bessel = besselI0(o.root * i.root * inverseDeviation_);
    const Lanes decay = exponential(-bessel.rest - versine * inverseVariance_);
    return o.a * correction(i) * i.cosine * norm_ * bessel.factor * decay;
  }

  /// Draws i from exactly that density: M by the inverse of its distribution (d'Eon et al. 2013), the rest by
  /// rejection.
  Inclination sample(size_t mode, const Outgoing& o, Random& random) const {
    const Inverse& inverse = inverse_[mode];
    for (;;) {
      // An exponential variable has no memory: what is left of it modulo 2 is the same law trimmed to [0, 2].
      const float decay = inverse.variance * -logarithm(1 - random.uniform());
      const float versine = decay - 2 * std::floor(0.5f * decay);
      const float across = std::sqrt(versine * (2 - versine)) * sinCosPi(2 * random.uniform() - 1).cosine;
      const float sine = withinOne((versine - 1) * o.sine[mode] + across * o.cosine[mode]);
      const Inclination i(sine, std::sqrt((1 - sine) * (1 + sine)));
      if (random.uniform() * inverse.bound < correction(mode, i) * i.cosine) return i;
    }
  }

  /// Bytes of the table of a().
  size_t bytes() const { return table_.size() * sizeof(Lanes); }

 private:
  struct Inverse {
    float variance = 0;  ///< v
    float bound = 0;     ///< largest a cos_i
  };

  /// a() is smooth in the cosine: one row for each of kRows equal steps from 0 to 1, and one more to interpolate with.
  struct Place {
    size_t row;
    float next;
  };
  static Place place(Inclination t) {
    const float x = t.cosine * static_cast<float>(kRows);
    return {static_cast<size_t>(static_cast<int>(x)), x - std::floor(x)};
  }
  Lanes correction(Inclination t) const {
    const Place p = place(t);
    return table_[p.row] + p.next * (table_[p.row + 1] - table_[p.row]);
  }
  float correction(size_t mode, Inclination t) const {
    const Place p = place(t);
    return table_[p.row][mode] + p.next * (table_[p.row + 1][mode] - table_[p.row][mode]);
  }
  void solve(size_t mode, double variance);

  static constexpr size_t kModes = 4;
  static constexpr size_t kRows = 512;
  bool tilted_ = false;
  std::array<SinCos, kModes> tilt_{};
  Lanes inverseVariance_{}, inverseDeviation_{}, norm_{};
  std::array<Inverse, kModes> inverse_{};
  std::vector<Lanes> table_;
};

}  // namespace loomlight::optics
