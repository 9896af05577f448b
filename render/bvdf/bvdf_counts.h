#pragma once

#include <cstdint>
#include <vector>

#include "render/bvdf/bvdf.h"

namespace loomlight {

/// What shadow rays have found so far, from which a Bvdf is made at any time: per bin, how many met a fibre, and how
/// many would have by the hot-spot law for the very angles that were shot.
class BvdfCounts {
 public:
  explicit BvdfCounts(BvdfResolution resolution) : resolution_(resolution), bins_(resolution.bins()) {}

  void add(size_t bin, bool met, float expected) {
    ++rays_;
    Bin& at = bins_[bin];
    at.met += met ? 1.0f : 0.0f;
    at.expected += expected;
  }
  uint64_t rays() const { return rays_; }

  /// The table of the rays so far: smoothed by a binomial filter [1 2 1]/4 in each angle, met and expected apart, so
  /// that bins with many rays count for more than those with few; and drawn towards the mean ratio of all bins as if
  /// `kPriorRays` more rays had found that. Usable from the first ray on.
  Bvdf table(HotSpot hotSpot) const;

 private:
  struct Bin {
    float met = 0;  ///< whole, and exact up to 2^24 rays a bin
    float expected = 0;
  };
  static constexpr float kPriorRays = 0.25f;

  std::vector<Bin> smoothed() const;

  BvdfResolution resolution_;
  std::vector<Bin> bins_;
  uint64_t rays_ = 0;
};

}  // namespace loomlight
