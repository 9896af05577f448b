#pragma once

#include <array>

#include "core/volume/pool/component.h"

namespace loomlight {

/// What fibre segments add up to: their length, and the moments that a distribution is fitted to. Sums of moments are
/// the moments of the union, so coarser levels and merged components lose nothing. One cache line. In double: thousands
/// of segments meet in a coarse voxel, and lambda must integrate to the yarn's length.
struct alignas(64) FibreMoments {
  Float64x4 squares{};  ///< sums of l times xx, yy, zz, xy of the tangent's components
  Float64x4 others{};   ///< sums of l xz, l yz, 0, l

  double length_mm() const { return others[3]; }
  void add(const FibreMoments& more) {
    squares += more.squares;
    others += more.others;
  }
  void add(const FibreMoments& more, double factor) {
    squares += factor * more.squares;
    others += factor * more.others;
  }
  /// A straight segment; d is its length and direction, mm (the last lane is not used).
  static FibreMoments ofSegment(Float64x4 d);
};

/// The fibres of many voxels, to be fitted together. All lengths are > 0.
inline constexpr int kFitBatch = 64;
using FitBatch = std::array<FibreMoments, kFitBatch>;

/// The distributions of the first `count` of them: m is the principal axis of the tensor (here of any length), s the
/// spread that has the same mean-square sine about it. Length densities are those of voxels of 1 mm^3. Eight are fitted
/// together, so `count` is rounded up to eights.
using FittedBatch = std::array<std::array<DistributionLanes, 2>, kFitBatch / kLanes<Float32x8>>;
void fitDistributions(const FitBatch& batch, int count, FittedBatch& fitted);

/// How much would be lost by describing both by one distribution: Ward's distance of the two normalised tensors.
double mergeCost(const FibreMoments& a, const FibreMoments& b);

inline FibreMoments FibreMoments::ofSegment(Float64x4 d) {
  const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const double f = length > 0 ? 1 / length : 0;
  const Float64x4 unit = d * f;
  return {Float64x4{d[0], d[1], d[2], d[0]} * Float64x4{unit[0], unit[1], unit[2], unit[1]},
          Float64x4{d[0], d[1], 0, 1} * Float64x4{unit[2], unit[2], 0, length}};
}

}  // namespace loomlight
