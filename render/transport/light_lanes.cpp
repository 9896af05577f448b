// How it works. This is colourOf() of path_light.h, for as many lights as a register holds, one in each lane. Each lane
// does what is done there in the same order, down to the four partial sums over the bands, so the colours are the same
// to the bit; what lights of one kind do not need is left out where it would change nothing. Lanes are lights and not
// bands, because then no register is partly empty, and how many there are of them changes no sum.
//
// This file is compiled once for each instruction set, and which one runs is found out as the program runs.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/transport/light_lanes.cpp"
#include <hwy/foreach_target.h>

#include "render/transport/light_lanes.h"
#include "render/walk/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

/// optics::exponential(). That of 2 to a whole power is made of the lowest bits of a float so large that they are whole
/// numbers, which takes fewer steps than to convert it.
HWY_INLINE Real exponential(Real x) {
  const Real t = most(x, Real(-40.0f)) * Real(1.44269504f);
  const Real whole = hn::Ceil(t.in);  // towards zero
  const Real rest = t - whole, square = rest * rest;
  const Real low =
      Real(1.0f) + rest * Real(0.6931470452f) + square * (Real(0.2402243312f) + rest * Real(0.05549093212f));
  const Real high = Real(0.009579859973f) + rest * Real(0.001275540135f) + square * Real(0.0001093289239f);
  const Whole exponent(hn::BitCast(WholeTag(), (whole + Real(0x1p23f + 127)).in));
  return (low + square * square * high) * realOfBits(shiftedLeft<23>(exponent));
}

/// As many lights as a register holds.
class Lights {
 public:
  HWY_INLINE Lights(const LightLanes& lights, const Colouring& colouring, size_t lane)
      : lights_(lights), colouring_(colouring), lane_(lane) {
    for (size_t mode = 0; mode < 4; ++mode) modes_[mode] = column(lights.modes[mode]);
    traverse_ = column(lights.traverse_mm);
    inside_ = column(lights.inside);
    onceOut_ = Real(1.0f) - inside_;
  }

  /// path_light_detail::sentOn().
  HWY_INLINE Real sentOn(Real traverse) const {
    const Real residual = traverse * traverse * traverse * onceOut_ / (Real(1.0f) - inside_ * traverse);
    return modes_[0] + traverse * (modes_[1] + traverse * modes_[2]) + residual * modes_[3];
  }

  HWY_INLINE Vector inPrimaries() const { return {primary(0), primary(1), primary(2)}; }

  template <bool kIsWithin, bool kIsSent>
  HWY_INLINE Vector inBands(const Vector& primaries) const {
    Vector partial[kPartialSums];
    for (size_t i = 0; i < kPartialSums; ++i) {
      Vector& channels = partial[i];
      channels = {Real(0.0f), Real(0.0f), Real(0.0f)};
      for (size_t j = i; j < kBands; j += kPartialSums) {
        Real left(1.0f);
        if constexpr (kIsWithin) left = withinFibres(j);
        if constexpr (kIsSent) {
          const float own_per_mm = colouring_.bands_per_mm[static_cast<size_t>(lights_.material)][j];
          const Real sent = sentOn(exponential(Real(-own_per_mm) * traverse_));
          left = kIsWithin ? left * sent : sent;
        }
        const EyeResponse& eye = colouring_.eye;
        left = left * (primaries.x * Real(eye.primaries[0][j]) + primaries.y * Real(eye.primaries[1][j]) +
                       primaries.z * Real(eye.primaries[2][j]));
        channels =
            channels + Vector{Real(eye.channels[0][j]), Real(eye.channels[1][j]), Real(eye.channels[2][j])} * left;
      }
    }
    return (partial[0] + partial[1]) + (partial[2] + partial[3]);
  }

  HWY_INLINE Vector colour() const {
    const Vector primaries = inPrimaries();
    const bool isSent =
        lights_.material != LightLanes::kNoFibre && colouring_.isSpectral(static_cast<size_t>(lights_.material));
    if (lights_.isWithin) return isSent ? inBands<true, true>(primaries) : inBands<true, false>(primaries);
    return isSent ? inBands<false, true>(primaries) : inBands<false, false>(primaries);
  }

 private:
  static constexpr size_t kPartialSums = 4;

  HWY_INLINE Real column(const LaneFloats& lanes) const { return Real::of(&lanes[lane_]); }
  HWY_INLINE Real length(size_t material) const { return column(lights_.lengths_mm[material].lanes); }

  HWY_INLINE Real primary(int channel) const {
    Real light = column(lights_.radiance[channel]);
    const std::vector<Rgb>& absorption_per_mm = colouring_.primaries_per_mm;
    if (lights_.isWithin) {
      Real exponent(0.0f);
      for (size_t k = 0; k < absorption_per_mm.size(); ++k)
        exponent = exponent + Real(absorption_per_mm[k][channel]) * length(k);
      light = light * exponential(-exponent);
    }
    if (lights_.material == LightLanes::kNoFibre) return light * modes_[0];
    const auto material = static_cast<size_t>(lights_.material);
    if (colouring_.isSpectral(material)) return light;
    return light * sentOn(exponential(-(Real(absorption_per_mm[material][channel]) * traverse_)));
  }

  HWY_INLINE Real withinFibres(size_t band) const {
    Real exponent(0.0f);
    for (uint64_t rest = colouring_.knownInBands; rest != 0; rest &= rest - 1) {
      const auto k = static_cast<size_t>(std::countr_zero(rest));
      exponent = exponent - Real(colouring_.bands_per_mm[k][band]) * length(k);
    }
    return exponential(exponent);
  }

  const LightLanes& lights_;
  const Colouring& colouring_;
  size_t lane_;  ///< the first of them
  Real modes_[4], traverse_, inside_, onceOut_;
};

void colourLanes(LightLanes& lights, const Colouring& colouring) {
  for (size_t lane = 0; lane < kWalkLanes; lane += hn::Lanes(RealTag())) {
    const Vector colour = Lights(lights, colouring, lane).colour();
    colour.x.to(&lights.colour[0][lane]);
    colour.y.to(&lights.colour[1][lane]);
    colour.z.to(&lights.colour[2][lane]);
  }
}

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loomlight {

HWY_EXPORT(colourLanes);

void colourLights(LightLanes& lights, const Colouring& colouring) {
  HWY_DYNAMIC_DISPATCH(colourLanes)(lights, colouring);
}

}  // namespace loomlight
#endif
