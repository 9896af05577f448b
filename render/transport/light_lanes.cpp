// How it works. These are the formulas of path_light-inl.h, for as many lights as a register holds, one in each lane.
// Lanes are lights and not bands, because then no register is partly empty, and how many there are of them changes no
// sum.
//
// This file is compiled once for each instruction set, and which one runs is found out as the program runs.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/transport/light_lanes.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <array>
#include <bit>

#include "render/transport/light_lanes.h"
#include "render/walk/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

#include "render/optics/exponential-inl.h"
#include "render/transport/path_light-inl.h"

/// A register of each number of some lights, as the formulas read it. What lights of one kind do not have is known as
/// this is compiled.
template <bool kIsSent, bool kIsWithin>
class Lanes {
 public:
  using Number = Real;
  using Bands = Real;
  static constexpr size_t kSideBySide = 1;

  HWY_INLINE Lanes(const LightColumns& lights, size_t first, Rgb lamps)
      : columns_(lights.block(first)), lane_(first % kWalkLanes), lengths_mm_(lights.lengths_mm()), lamps_(lamps) {
    if constexpr (kIsSent) {
      sender_ = lights.kind().material;
      for (size_t p = 0; p < modes_.size(); ++p) modes_[p] = column(LightColumns::kModes + p);
      traverse_mm_ = column(LightColumns::kTraverse_mm);
      internalReflectance_ = column(LightColumns::kInternalReflectance);
    }
  }

  HWY_INLINE static Real of(const Rgb& rgb, size_t c) { return rgb[static_cast<int>(c)]; }
  HWY_INLINE static Real of(const Spectrum& spectrum, size_t j) { return spectrum[j]; }

  HWY_INLINE int sender() const { return sender_; }
  HWY_INLINE Real mode(size_t p) const { return modes_[p]; }
  HWY_INLINE Real traverse_mm() const { return traverse_mm_; }
  HWY_INLINE Real internalReflectance() const { return internalReflectance_; }
  HWY_INLINE Real radiance(size_t c) const { return column(LightColumns::kRadiance + c) * of(lamps_, c); }
  HWY_INLINE static bool isWithin() { return kIsWithin; }
  HWY_INLINE static bool isWithin(size_t) { return true; }
  HWY_INLINE Real length_mm(size_t k) const { return column(lengths_mm_ + k); }

  HWY_INLINE static std::array<Real, 3> apart(const std::array<Real, 3>& primaries) { return primaries; }
  HWY_INLINE static Real sum(const std::array<Real, 4>& partial) {
    return (partial[0] + partial[1]) + (partial[2] + partial[3]);
  }

 private:
  HWY_INLINE Real column(size_t i) const { return Real::of(&columns_[i].lanes[lane_]); }

  const LightColumns::Column* columns_;
  size_t lane_, lengths_mm_;
  Rgb lamps_;
  int sender_ = PathLight::kNoFibre;
  std::array<Real, FibreBcsdf::kModes> modes_;  // only where a fibre sent the lights, and so are the next two
  Real traverse_mm_, internalReflectance_;
};

template <bool kIsSent, bool kIsWithin>
void addColoursOfKind(const LightColumns& lights, const Colouring& colouring, Rgb lamps, std::span<Rgb> samples) {
  const std::span<const uint32_t> samplesOf = lights.samples();
  const size_t most = hn::Lanes(RealTag());
  for (size_t first = 0; first < lights.size(); first += most) {
    const std::array<Real, 3> colour = colourOf(Lanes<kIsSent, kIsWithin>(lights, first, lamps), colouring);
    alignas(64) LaneFloats channels[3];
    for (size_t c = 0; c < 3; ++c) colour[c].to(channels[c].data());
    const size_t count = std::min(most, lights.size() - first);
    for (size_t i = 0; i < count; ++i)
      samples[samplesOf[first + i]] += Rgb(channels[0][i], channels[1][i], channels[2][i]);
  }
}

void addColoursInLanes(const LightColumns& lights, const Colouring& colouring, Rgb lamps, std::span<Rgb> samples) {
  const LightColumns::Kind& kind = lights.kind();
  if (kind.material == PathLight::kNoFibre)
    (kind.isWithin ? addColoursOfKind<false, true> : addColoursOfKind<false, false>)(lights, colouring, lamps, samples);
  else
    (kind.isWithin ? addColoursOfKind<true, true> : addColoursOfKind<true, false>)(lights, colouring, lamps, samples);
}

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loomlight {

HWY_EXPORT(addColoursInLanes);

void addColours(const LightColumns& lights, const Colouring& colouring, Rgb lamps, std::span<Rgb> samples) {
  HWY_DYNAMIC_DISPATCH(addColoursInLanes)(lights, colouring, lamps, samples);
}

}  // namespace loomlight
#endif
