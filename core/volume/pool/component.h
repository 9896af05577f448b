#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/simd.h"
#include "core/base/units.h"
#include "core/volume/pool/voxel_box.h"

namespace loomlight {

/// The fibres of one yarn (or ply) in one voxel, statistically: Eq. 1 of the report, decoded.
struct FibreDistribution {
  glm::vec3 direction{0, 0, 1};  ///< unit mean tangent m in cloth space; a line, m and -m are the same
  float spread = 0;              ///< s, radians per axis of an isotropic two-dimensional Gaussian about m, 0..1
  float lengthDensity = 0;       ///< lambda = sum of clipped segment lengths / voxel volume, 1/mm^2
};

/// Four of them side by side.
struct DistributionLanes {
  Float64x4 x, y, z;  ///< direction
  Float64x4 spread, lengthDensity;
};

/// A FibreDistribution in 8 bytes: direction 2 x 12 bits and spread 8, from the low bits up; length density 16; and the
/// VoxelBox that its fibres lie in, 16.
///
/// - Direction: an octahedral map of the upper hemisphere alone, because m and -m are the same line: twice as fine as a
///   map of the sphere; off by at most 0.6 mrad. The axes x, y, z are exact.
/// - Spread: its square root in 255 steps, finest where it matters, near 0; 0 and 1 are exact.
/// - Length density: a float of 5 exponent and 11 mantissa bits, 2^-12 (2.4e-4) to 2^20 (1.0e6) per mm^2, off by at
///   most 0.025 %; 0 is exact, less than half the smallest becomes 0, more than the largest becomes the largest.
class Component {
 public:
  Component() = default;
  static Component encode(const FibreDistribution& distribution);
  /// Eight at once; their directions may be of any length.
  static void encode(const std::array<DistributionLanes, 2>& distributions, Component* eight);
  FibreDistribution decode() const;
  /// Of decode(), that number alone.
  float lengthDensity() const;
  /// The same with a length density so many codes higher or lower, as far as there are any; a length density of 0
  /// stays.
  Component withDensitySteps(int steps) const;
  /// Where in the voxel the fibres lie; the length density is that of the voxel all the same.
  VoxelBox box() const { return VoxelBox::of(box_); }
  Component within(VoxelBox box) const {
    Component c = *this;
    c.box_ = box.code();
    return c;
  }

  /// All of it: equal components have equal bits.
  uint64_t bits() const {
    return directionAndSpread_ | static_cast<uint64_t>(density_) << 32 | static_cast<uint64_t>(box_) << 48;
  }
  friend bool operator==(Component, Component) = default;

  // How it is stored, for those who decode many side by side (render/walk):
  /// Codes 0..4094 of an octahedral coordinate are -1..1, and 0 is one of them.
  static constexpr int kAxisCentre = 2047;
  /// What is added to a length density's code, 12 bits up, to make the bits of a float; code 0 is zero.
  static constexpr uint32_t kDensityBias = (127u - 12u) << 23;

 private:
  static glm::vec3 decodeDirection(uint32_t bits);
  static Int32x8 encodeDirections(const std::array<DistributionLanes, 2>& distributions);
  static Int32x4 encodeDensity(Float64x4 lengthDensity);

  uint32_t directionAndSpread_ = 0;
  uint16_t density_ = 0;
  uint16_t box_ = VoxelBox().code();
};
static_assert(sizeof(Component) == 8);

inline glm::vec3 Component::decodeDirection(uint32_t bits) {
  constexpr float kStep = 1.0f / kAxisCentre;
  const float u = static_cast<float>(static_cast<int>(bits & 0xFFF) - kAxisCentre) * kStep;
  const float v = static_cast<float>(static_cast<int>(bits >> 12 & 0xFFF) - kAxisCentre) * kStep;
  const float x = 0.5f * (u + v), y = 0.5f * (u - v);
  const float z = 1.0f - std::max(std::abs(u), std::abs(v));  // |x| + |y| = max(|u|, |v|)
  const float scale = 1.0f / std::sqrt(x * x + y * y + z * z);
  return {x * scale, y * scale, z * scale};
}

inline float Component::lengthDensity() const {
  return density_ == 0 ? 0.0f : std::bit_cast<float>((static_cast<uint32_t>(density_) << 12) + kDensityBias);
}

inline Component Component::withDensitySteps(int steps) const {
  Component c = *this;
  if (density_ != 0) c.density_ = static_cast<uint16_t>(std::clamp(density_ + steps, 1, 0xFFFF));
  return c;
}

inline FibreDistribution Component::decode() const {
  const uint32_t bits = directionAndSpread_;
  const float root = static_cast<float>(bits >> 24) * (1.0f / 255.0f);
  FibreDistribution d;
  d.direction = decodeDirection(bits);
  d.spread = root * root;
  d.lengthDensity = lengthDensity();
  return d;
}

}  // namespace loomlight
