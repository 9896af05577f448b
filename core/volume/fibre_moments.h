#pragma once

#include <glm/glm.hpp>

#include "core/volume/component.h"

namespace loomlight {

/// What fibre segments add up to: their length, and the moments that a distribution is fitted to. Sums of moments are
/// the moments of the union, so coarser levels and merged components lose nothing. One cache line.
struct alignas(64) FibreMoments {
  // sum of l t t^T: xx, yy, zz, xy, xz, yz; sum of l packing; sum of l. In double: thousands of segments meet in a
  // coarse voxel, and lambda must integrate to the yarn's length.
  double sums[8] = {};

  double length_mm() const { return sums[7]; }
  void add(const FibreMoments& other, double factor = 1) {
    for (int i = 0; i < 8; ++i) sums[i] += factor * other.sums[i];
  }
  /// A straight segment; d is its length and direction, mm.
  static FibreMoments ofSegment(glm::dvec3 d, double packing);
};

/// The distribution of these fibres in a voxel: m is the principal axis of the tensor, s the spread that has the same
/// mean-square sine about it. Its length is > 0.
FibreDistribution fitDistribution(const FibreMoments& moments, double voxelVolume_mm3, int material);

/// How much would be lost by describing both by one distribution: Ward's distance of the two normalised tensors.
double mergeCost(const FibreMoments& a, const FibreMoments& b);

inline FibreMoments FibreMoments::ofSegment(glm::dvec3 d, double packing) {
  const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  const double f = length > 0 ? 1 / length : 0;
  return {{d.x * d.x * f, d.y * d.y * f, d.z * d.z * f, d.x * d.y * f, d.x * d.z * f, d.y * d.z * f, length * packing,
           length}};
}

}  // namespace loomlight
