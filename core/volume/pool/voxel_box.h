#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/simd.h"
#include "core/base/units.h"

namespace loomlight {

/// Where in its voxel a component's fibres lie: a box along the axes of the cloth, in sevenths of the voxel. At the rim
/// of a yarn fibres fill a part of a voxel, and the rest is gap, through which light comes; spread over the voxel, they
/// would close it. 15 bits.
class VoxelBox {
 public:
  static constexpr int kParts = 7;
  /// The whole voxel.
  VoxelBox() = default;
  /// The nearest box to one, in widths of the voxel from its lower corner; never empty.
  static VoxelBox nearest(Float32x4 lower, Float32x4 upper);

  /// In sevenths of the voxel, each 0..7.
  glm::ivec3 lower() const { return {edges(0).lower, edges(1).lower, edges(2).lower}; }
  glm::ivec3 upper() const { return {edges(0).upper, edges(1).upper, edges(2).upper}; }
  /// In widths of the voxel.
  glm::vec3 lowerCorner() const { return (1.0f / kParts) * glm::vec3(lower()); }
  glm::vec3 upperCorner() const { return (1.0f / kParts) * glm::vec3(upper()); }
  /// Of a place in widths of the voxel.
  bool contains(glm::vec3 inVoxel) const {
    return glm::all(glm::lessThanEqual(lowerCorner(), inVoxel)) && glm::all(glm::lessThan(inVoxel, upperCorner()));
  }
  /// How many times the density in the box is that of the fibres spread over the voxel.
  float crowding() const {
    const glm::vec3 size = upperCorner() - lowerCorner();
    return 1.0f / (size.x * size.y * size.z);
  }
  uint16_t code() const { return code_; }
  static VoxelBox of(uint16_t code) {
    VoxelBox box;
    box.code_ = code;
    return box;
  }
  /// The smallest box around both.
  friend VoxelBox around(VoxelBox a, VoxelBox b);
  friend bool operator==(VoxelBox, VoxelBox) = default;

  // How it is stored, for those who decode many side by side (render/walk): 5 bits of each axis, a in the upper two and
  // b in the others. Where a < b the edges are a and b, else 7 - a and 7 - b: so all 28 pairs have a code.
  static constexpr int kAxisBits = 5;

 private:
  struct Edges {
    int lower, upper;
  };
  Edges edges(int axis) const {
    const int code = code_ >> (kAxisBits * axis) & 31, a = code >> 3, b = code & 7;
    return a < b ? Edges{a, b} : Edges{kParts - a, kParts - b};
  }
  static int codeOf(Edges edges) {
    if (edges.lower > 3) edges = {kParts - edges.lower, kParts - edges.upper};
    return edges.lower << 3 | edges.upper;
  }

  static constexpr uint16_t kWhole = kParts | kParts << kAxisBits | kParts << 2 * kAxisBits;
  uint16_t code_ = kWhole;
};

inline VoxelBox VoxelBox::nearest(Float32x4 lower, Float32x4 upper) {
  const auto part = [](Float32x4 place, float last) {
    return __builtin_convertvector(least(most(place, Float32x4{}), Float32x4{} + last), Int32x4);
  };
  const Float32x4 from = static_cast<float>(kParts) * lower, to = static_cast<float>(kParts) * upper;
  Int32x4 a = part(from + 0.5f, kParts), b = part(to + 0.5f, kParts);
  // What is thinner than a part is the one that its middle is in.
  const Int32x4 middle = part(0.5f * (from + to), kParts - 1), thin = a >= b;
  a = thin ? middle : a;
  b = thin ? middle + 1 : b;
  const Int32x4 beyond = a > kParts / 2;  // as codeOf()
  const Int32x4 code = (beyond ? kParts - a : a) << 3 | (beyond ? kParts - b : b);
  return of(static_cast<uint16_t>(code[0] | code[1] << kAxisBits | code[2] << 2 * kAxisBits));
}

inline VoxelBox around(VoxelBox a, VoxelBox b) {
  int code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const VoxelBox::Edges x = a.edges(axis), y = b.edges(axis);
    code |= VoxelBox::codeOf({std::min(x.lower, y.lower), std::max(x.upper, y.upper)}) << (VoxelBox::kAxisBits * axis);
  }
  return VoxelBox::of(static_cast<uint16_t>(code));
}

}  // namespace loomlight
