#pragma once

#include <span>
#include <vector>

#include "render/bvdf/bvdf_bins.h"
#include "render/bvdf/hot_spot.h"

namespace loomlight {

/// Bidirectional visibility distribution function of a yarn (section 8.2 of the report): p(wi, wo), the probability
/// that a shadow ray towards wi, from where an eye ray that came from wo first met a fibre, meets another within the
/// cell around it, which is twice as wide as a leaf of the volume. A table of ratios to the hot-spot law, interpolated
/// in all four angles; so p is exactly 0 at wi == wo, and its cusp there is sharp whatever the resolution. Immutable.
class Bvdf {
 public:
  /// `ratios`: one a bin, by BvdfBin::index; finite and not negative.
  Bvdf(BvdfResolution resolution, HotSpot hotSpot, std::vector<float> ratios);

  /// p, 0..1. Unit directions in the event's frame (eventFrame()), both pointing away from the event. Use 1 - p as the
  /// weight of a shadow ray: its expectation has no noise.
  float occlusion(glm::vec3 wi, glm::vec3 wo) const;

  const BvdfResolution& resolution() const { return resolution_; }
  const HotSpot& hotSpot() const { return hotSpot_; }
  std::span<const float> ratios() const { return ratios_; }
  bool operator==(const Bvdf&) const = default;

 private:
  BvdfResolution resolution_;
  HotSpot hotSpot_;
  std::vector<float> ratios_;
};

}  // namespace loomlight
