#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/base/units.h"
#include "render/optics/polynomials.h"

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
/// angles. Sinkhorn's scaling repairs that. With A(o) the share of the mode, mean over the offset h, and a() solving
///   a(o) * integral of a(i) M(o, i) cos_i^2 di = A(o),
/// a(o) a(i) M(o, i) is symmetric, so the fibre is reciprocal; and summed over the modes it carries, from either side,
/// the sum of A, which is one: no light is lost or made. Given the mode, i has the density a(o) a(i) M cos_i / A(o).
class LongitudinalLobes {
 public:
  /// roughness: beta_m in [0.05, 1]; index: refractive.
  LongitudinalLobes(double roughness, double index, double scaleTilt_rad);

  /// Where wo lies, as every mode sees it: shifted by the tilt of the scales.
  struct Outgoing {
    Float32x4 sine, cosine, root;
    Float32x4 factor;  ///< a(o) / A(o)
  };
  Outgoing outgoing(Inclination o) const {
    if (!tilted_)
      return {broadcast<Float32x4>(o.sine), broadcast<Float32x4>(o.cosine), broadcast<Float32x4>(o.root),
              lookUp(outgoing_, o)};
    Outgoing shifted;
    for (size_t mode = 0; mode < kModes; ++mode) {
      const float sine = o.sine * tilt_[mode].cosine + o.cosine * tilt_[mode].sine;
      const Inclination s(sine, std::abs(o.cosine * tilt_[mode].cosine - o.sine * tilt_[mode].sine));
      shifted.sine[mode] = s.sine;
      shifted.cosine[mode] = s.cosine;
      shifted.root[mode] = s.root;
      shifted.factor[mode] = lookUp(outgoing_, mode, s);
    }
    return shifted;
  }

  /// Density of i per radian and cos_i, for every mode.
  Float32x4 density(const Outgoing& o, Inclination i) const {
    // 1 - cos(o + i) as half a squared distance: narrow lobes would not survive the difference.
    const Float32x4 sines = o.sine + i.sine, cosines = o.cosine - i.cosine;
    const Float32x4 versine = 0.5f * (sines * sines + cosines * cosines);
    const BesselI0 bessel = besselI0(o.root * i.root * inverseDeviation_);
    const Float32x4 decay = exponential(-bessel.rest - versine * inverseVariance_);
    return o.factor * lookUp(incoming_, i) * i.cosine * norm_ * bessel.factor * decay;
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
      if (random.uniform() * inverse.bound < lookUp(incoming_, mode, i) * i.cosine) return i;
    }
  }

  /// Bytes of the tables.
  size_t bytes() const { return (outgoing_.size() + incoming_.size()) * sizeof(Float32x4); }

 private:
  static constexpr size_t kModes = 4;
  static constexpr size_t kRows = 512;

  struct Inverse {
    float variance = 0;  ///< v
    float bound = 0;     ///< largest a(i) cos_i
  };

  /// Functions of the cosine: one row for each of kRows equal steps from 0 to 1, and one more to interpolate with.
  using Table = std::vector<Float32x4>;
  struct TablePosition {
    size_t row;
    float next;
  };
  static TablePosition positionOf(Inclination t) {
    const float x = t.cosine * static_cast<float>(kRows);
    return {static_cast<size_t>(static_cast<int>(x)), x - std::floor(x)};
  }
  static Float32x4 lookUp(const Table& table, Inclination t) {
    const TablePosition p = positionOf(t);
    return table[p.row] + p.next * (table[p.row + 1] - table[p.row]);
  }
  static float lookUp(const Table& table, size_t mode, Inclination t) {
    const TablePosition p = positionOf(t);
    return table[p.row][mode] + p.next * (table[p.row + 1][mode] - table[p.row][mode]);
  }
  void solve(size_t mode, double variance, double index);

  bool tilted_;
  std::array<SinCos, kModes> tilt_{};
  Float32x4 inverseVariance_{}, inverseDeviation_{}, norm_{};
  std::array<Inverse, kModes> inverse_{};
  Table outgoing_, incoming_;  ///< a / A, and a
};

}  // namespace loomlight::optics
