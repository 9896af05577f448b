#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/random_lanes.h"
#include "core/base/units.h"
#include "render/optics/polynomials.h"

namespace loomlight::optics {

/// An inclination to the plane across the fibre; the cosine lies in [0, 1].
template <class T>
struct Inclination {
  T sine, cosine;
  T root;  ///< of the cosine

  Inclination(T sine, T cosine) : sine(sine), cosine(cosine), root(squareRoot(cosine)) {}
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
  template <class T>
  struct Outgoing {
    ModesOf<T> sine, cosine, root;
    ModesOf<T> factor;  ///< a(o) / A(o)
  };
  template <class T>
  Outgoing<T> outgoing(const Inclination<T>& o) const {
    if (!tilted_)
      return {{o.sine, o.sine, o.sine, o.sine},
              {o.cosine, o.cosine, o.cosine, o.cosine},
              {o.root, o.root, o.root, o.root},
              lookUp(outgoing_, o.cosine)};
    Outgoing<T> shifted;
    for (size_t mode = 0; mode < kModes; ++mode) {
      const float tiltSine = tilt_[mode].sine, tiltCosine = tilt_[mode].cosine;
      const Inclination<T> s(o.sine * tiltCosine + o.cosine * tiltSine,
                             magnitude<T>(o.cosine * tiltCosine - o.sine * tiltSine));
      shifted.sine[mode] = s.sine;
      shifted.cosine[mode] = s.cosine;
      shifted.root[mode] = s.root;
      shifted.factor[mode] = lookUp(outgoing_, broadcastWhole<T>(mode), s.cosine);
    }
    return shifted;
  }

  /// Density of i per radian and cos_i, for every mode.
  template <class T>
  ModesOf<T> density(const Outgoing<T>& o, const Inclination<T>& i) const {
    ModesOf<T> result = lookUp(incoming_, i.cosine);
    for (size_t mode = 0; mode < kModes; ++mode) {
      // 1 - cos(o + i) as half a squared distance: narrow lobes would not survive the difference.
      const T sines = o.sine[mode] + i.sine, cosines = o.cosine[mode] - i.cosine;
      const T versine = 0.5f * (sines * sines + cosines * cosines);
      const BesselI0<T> bessel = besselI0<T>(o.root[mode] * i.root * inverseDeviation_[mode]);
      const T decay = exponential<T>(-bessel.rest - versine * inverseVariance_[mode]);
      result[mode] = o.factor[mode] * result[mode] * i.cosine * norm_[mode] * bessel.factor * decay;
    }
    return result;
  }

  /// Draws i from exactly that density: M by the inverse of its distribution (d'Eon et al. 2013), the rest by
  /// rejection.
  template <class T>
  Inclination<T> sample(WholeOf<T> mode, const Outgoing<T>& o, RandomLanes<T>& random) const {
    const T variance = chosen<T>(mode, variance_), bound = chosen<T>(mode, bound_);
    const T sineO = chosen<T>(mode, o.sine), cosineO = chosen<T>(mode, o.cosine);
    MaskOf<T> open = random.inUse();
    T sine{}, cosine{};
    do {
      // An exponential variable has no memory: what is left of it modulo 2 is the same law trimmed to [0, 2].
      const auto [u1, u2] = random.uniformPair(open);
      const T decay = variance * -logarithm<T>(1 - u1);
      const T versine = decay - 2 * toFloats<T>(truncated<T>(0.5f * decay));
      const T across = squareRoot<T>(versine * (2 - versine)) * sinCosPi<T>(2 * u2 - 1).cosine;
      const T s = withinOne<T>((versine - 1) * sineO + across * cosineO), c = squareRoot<T>((1 - s) * (1 + s));
      sine = open ? s : sine;
      cosine = open ? c : cosine;
      open = open & (random.uniform(open) * bound >= lookUp(incoming_, mode, c) * c);
    } while (any(open));
    return {sine, cosine};
  }

 private:
  static constexpr size_t kModes = 4;
  static constexpr size_t kRows = 512;

  /// Functions of the cosine: one row for each of kRows equal steps from 0 to 1, and one more to interpolate with.
  using Table = std::vector<Float32x4>;
  template <class T>
  static WholeOf<T> broadcastWhole(size_t n) {
    return WholeOf<T>{} + static_cast<int32_t>(n);
  }
  /// For every mode.
  static ModesOf<float> lookUp(const Table& table, float cosine) {
    const float x = cosine * static_cast<float>(kRows);
    const auto row = static_cast<size_t>(static_cast<int>(x));
    const Float32x4 found = table[row] + (x - std::floor(x)) * (table[row + 1] - table[row]);
    return {found[0], found[1], found[2], found[3]};
  }
  static ModesOf<Float32x8> lookUp(const Table& table, Float32x8 cosine) {
    const Float32x8 x = cosine * static_cast<float>(kRows);
    const Int32x8 row = truncated(x);
    const Float32x8 next = x - toFloats<Float32x8>(row);
    std::array<Float32x4, 8> found;
    for (size_t lane = 0; lane < 8; ++lane) {
      const Float32x4* rows = &table[static_cast<size_t>(row[lane])];
      found[lane] = rows[0] + next[lane] * (rows[1] - rows[0]);
    }
    return transposed(found);
  }
  /// For one mode of each.
  template <class T>
  static T lookUp(const Table& table, WholeOf<T> mode, T cosine) {
    const T x = cosine * static_cast<float>(kRows);
    const WholeOf<T> row = truncated(x), place = row * static_cast<int32_t>(kModes) + mode;
    const auto* numbers = reinterpret_cast<const float*>(table.data());
    const T here = gathered(numbers, place), there = gathered(numbers + kModes, place);
    return here + (x - toFloats<T>(row)) * (there - here);
  }

  bool tilted_;
  std::array<SinCos<float>, kModes> tilt_{};
  ModesOf<float> inverseVariance_{}, inverseDeviation_{}, norm_{};
  ModesOf<float> variance_{};  ///< v
  ModesOf<float> bound_{};     ///< largest a(i) cos_i
  Table outgoing_, incoming_;  ///< a / A, and a
};

}  // namespace loomlight::optics
