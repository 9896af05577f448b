// How rays go through the boxes of a voxel's components, side by side: each component has a stretch of the ray of its
// own, along which light uses up depth. Compiled once for each instruction set, as lanes-inl.h is.
#if defined(LOOMLIGHT_STRETCH_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LOOMLIGHT_STRETCH_LANES_INL_H_
#undef LOOMLIGHT_STRETCH_LANES_INL_H_
#else
#define LOOMLIGHT_STRETCH_LANES_INL_H_
#endif

#include "render/walk/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

/// The light of each ray as it comes to a voxel; places are in mm along the ray.
struct LightLanes {
  Real start, end;    ///< of its way through the segment of the cloth
  Real ahead;         ///< so far before the axes of fibres light meets their surfaces, mm
  Real lastEnd;       ///< where the fibres of the voxel before ended
  Real filledBefore;  ///< how much of the space was fibre there, 0..1
};

/// In one voxel, the stretches of as many rays as a register holds, in mm along each ray.
class StretchLanes {
 public:
  static constexpr int kMost = 2 * CellLanes::kSlots;

  HWY_INLINE StretchLanes() {}

  /// Begins a voxel that the rays enter and leave there; it has no stretches yet.
  HWY_INLINE void clear(Real enter, Real leave) {
    count_ = 0;
    first_ = leave;
    last_ = enter;
    kept_mm_ = Real(0.0f);
    apart_ = enter < enter;
  }

  /// Adds that of a component: from where to where its axes are, what the ray meets of them (1/mm), and how much of the
  /// space is fibre that others keep out of (0..). Of a ray that goes by the component, `to` is before `from`. `boxed`:
  /// the component fills a part of the voxel.
  HWY_INLINE void add(Real from, Real to, Real sigma, Real kept, Mask boxed) {
    first_ = least(first_, from);
    last_ = most(last_, to);
    kept_mm_ = kept_mm_ + kept * most(Real(0.0f), to - from);
    apart_ = apart_ | boxed;
    Stretch& s = stretches_[count_++];
    s.from = from;
    s.to = to;
    s.sigma = sigma;
    s.kept = kept;
  }

  /// Where the first of the stretches begins, and where the last of them ends.
  HWY_INLINE Real first() const { return first_; }
  HWY_INLINE Real last() const { return last_; }

  /// How much of the space is fibre where the last stretch ends, 0..kFullest.
  HWY_INLINE Real filledAtLast() const {
    Real filled(0.0f);
    for (int i = 0; i < count_; ++i) {
      const Stretch& s = stretches_[i];
      filled = filled + orZero((s.from < s.to) & (last_ - s.to < Real(kTouching)), s.kept);
    }
    return least(filled, Real(kFullest));
  }

  /// Finds out what depth light uses up along each stretch, and returns the sum. Up to `near` of a stretch the light is
  /// not in it yet: gaps count as in the voxel before where that touches the stretch, and else as if nothing were
  /// there, even among other fibres of this voxel. Where the boxes of several components overlap, their fibres fill the
  /// space together: the mean over all that they take up says how much, or the fibres of the one where these alone are
  /// more.
  HWY_INLINE Real spend(const LightLanes& light, bool packing) {
    const Real one(1.0f), zero(0.0f);
    const Mask some = first_ < last_;
    const Real together = orZero(some, kept_mm_ / choose(some, last_ - first_, one));
    const Real widerBefore = one / (one - light.filledBefore);
    const Real from = light.start + light.ahead, to = light.end + light.ahead;
    Real depth(0.0f);
    sigmaNear_ = sigmaFar_ = zero;
    for (int i = 0; i < count_; ++i) {
      Stretch& s = stretches_[i];
      const Mask touches = s.from - light.lastEnd < Real(kTouching);
      s.start = most(s.from, from);
      s.length = most(zero, least(s.to, to) - s.start);
      s.near = least(most(s.from + light.ahead - s.start, zero), s.length);
      s.sigmaNear = s.sigma * choose(touches, widerBefore, one);
      s.sigmaFar = packing ? s.sigma / (one - least(most(s.kept, together), Real(kFullest))) : s.sigma;
      sigmaNear_ = sigmaNear_ + s.sigmaNear;
      sigmaFar_ = sigmaFar_ + s.sigmaFar;
      depth = depth + s.sigmaNear * s.near + s.sigmaFar * (s.length - s.near);
    }
    return depth;
  }

  /// Where along the axes a depth is used up that is less than what spend() has returned. Rays of `several` have more
  /// than one stretch.
  HWY_INLINE Real placeOf(Real depth, Mask several) const {
    const Stretch& alike = stretches_[0];
    const Real one(1.0f), beyond = depth - sigmaNear_ * alike.near;
    const Real within = choose(beyond < Real(0.0f), depth / choose(Real(0.0f) < sigmaNear_, sigmaNear_, one),
                               alike.near + beyond / choose(Real(0.0f) < sigmaFar_, sigmaFar_, one));
    const Mask differ = several & apart_;
    return any(differ) ? choose(differ, placeAmong(depth), alike.start + within) : alike.start + within;
  }

 private:
  static constexpr float kFullest = 0.9f;    // of space; no gap is so narrow that light could not be in it
  static constexpr float kTouching = 1e-5f;  // mm

  struct Stretch {
    Real from, to, sigma, kept;
    Real start, near, length;  ///< of the part that light can meet: from where, how much of it is near, and all
    Real sigmaNear, sigmaFar;  ///< what light meets there, in the gaps as they are: 1/mm
  };

  /// What is used up as far as a place.
  HWY_INLINE Real depthTo(Real place) const {
    Real sum(0.0f);
    for (int i = 0; i < count_; ++i) {
      const Stretch& s = stretches_[i];
      const Real along = most(Real(0.0f), least(place - s.start, s.length)), near = least(along, s.near);
      sum = sum + s.sigmaNear * near + s.sigmaFar * (along - near);
    }
    return sum;
  }

  /// Depth grows evenly between the places where a stretch begins, comes to its second part, or ends: so it is known at
  /// the nearest of them before and beyond.
  HWY_INLINE Real placeAmong(Real depth) const {
    Real before = first_, beyond = last_;
    for (int i = 0; i < count_; ++i) {
      const Stretch& s = stretches_[i];
      for (const Real place : {s.start, s.start + s.near, s.start + s.length}) {
        const Mask reached = depthTo(place) <= depth;
        before = choose(reached, most(before, place), before);
        beyond = choose(reached, beyond, least(beyond, place));
      }
    }
    const Real depthBefore = depthTo(before), grown = depthTo(beyond) - depthBefore;
    const Mask grows = Real(0.0f) < grown;
    const Real share = least(Real(1.0f), (depth - depthBefore) / choose(grows, grown, Real(1.0f)));
    return before + orZero(grows, share) * (beyond - before);
  }

  Stretch stretches_[kMost];
  int count_ = 0;
  Real first_, last_;
  Real kept_mm_;               ///< lengths of the stretches by how much of them is fibre
  Real sigmaNear_, sigmaFar_;  ///< of all
  Mask apart_;                 ///< stretches may differ
};

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
