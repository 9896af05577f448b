#pragma once

#include <cstdint>

#include "core/base/units.h"

namespace loomlight {

/// The fibres of one yarn (or ply) in one voxel, statistically: Eq. 1 of the report, decoded.
struct FibreDistribution {
  glm::vec3 direction{0, 0, 1};  ///< unit mean tangent m; a line, m and -m are the same
  float spread = 0;              ///< s, radians per axis of an isotropic two-dimensional Gaussian about m, 0..1
  float lengthDensity = 0;       ///< lambda = sum of clipped segment lengths / voxel volume, 1/mm^2
  float packing = 0;             ///< length-weighted fibre volume fraction around the fibres, 0..1
  int material = 0;              ///< which fibre of the yarn's blend
};

/// A FibreDistribution in 8 bytes: octahedral direction 2 x 12 bits, spread 8 bits, packing 8 bits, material 8 bits,
/// logarithmic length density 16 bits.
class Component {
 public:
  Component() = default;
  static Component encode(const FibreDistribution& distribution);
  FibreDistribution decode() const;

  uint64_t bits() const { return bits_; }
  friend bool operator==(Component, Component) = default;

 private:
  uint64_t bits_ = 0;
};
static_assert(sizeof(Component) == 8);

}  // namespace loomlight
