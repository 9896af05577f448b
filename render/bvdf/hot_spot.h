#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/base/units.h"

namespace loomlight {

/// How much a shadow ray profits from the eye's ray having come through: whatever would be met by both has not been
/// met by the one. A point at distance s on a shadow ray at angle g to the eye's is s sin(g) off the cleared path, so a
/// fibre of radius r there is new with probability min(1, s sin(g) / 2r); the optical depth over a distance D, sigma D
/// for unrelated rays, is the integral of that (after the hot spot of leaf canopies, Kuusk 1985). It is 0 at g = 0 with
/// a cusp that no table of angles can hold; a measured occlusion over this one is smooth.
struct HotSpot {
  float depth = 1;  ///< sigma D: of an unrelated ray through half the cell
  float reach = 1;  ///< 2 r / D
  bool operator==(const HotSpot&) const = default;

  /// Of fibres of radius r that fill a share `packing` of the room, seen along a distance D.
  static HotSpot of(float radius_mm, float packing, float distance_mm) {
    return {2 * packing / (static_cast<float>(kPi) * radius_mm) * distance_mm, 2 * radius_mm / distance_mm};
  }

  /// Probability that a shadow ray towards wi meets a fibre, 0 for wi == wo. Constant beyond a right angle: there the
  /// shadow ray goes where the eye has not been. Unit directions.
  float occlusion(glm::vec3 wi, glm::vec3 wo) const {
    // |wi - wo| keeps the digits of small angles, where a cosine has none.
    const glm::vec3 difference = wi - wo;
    const float chord2 = glm::dot(difference, difference);  // 2 - 2 cos g
    const float cosine = 1 - 0.5f * chord2;
    const float sine = cosine <= 0 ? 1.0f : std::sqrt(std::max(0.0f, chord2 * (1 - 0.25f * chord2)));
    const float share = sine < reach ? 0.5f * sine / reach : 1 - 0.5f * reach / sine;
    return -std::expm1(-depth * share);
  }
};

}  // namespace loomlight
