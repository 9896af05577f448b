#include "core/volume/build/leaf_filler.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

// How it works. A strand is a polyline; what a voxel gets is the part of it that lies inside. Sums of the moments are
// taken along the strand once, so that the part between any two points of it is a difference of two sums, and no
// segment is cut. sumUp() makes the sums, measure() notes for each segment where it crosses the first voxel face of
// each axis; findCrossings() lists the crossings of one axis in order; follow() merges the three lists, and at every
// crossing gives the voxel that is left the moments since the crossing before. A crossing is a 64-bit number, segment
// above and share of it below, so that comparing two numbers tells which comes first. Nothing branches but for segments
// that cross several faces of one axis.
//
// A fibre is not a line but has a section: each strand is followed twice, by lines that waver to both sides of its
// axis.

namespace loomlight {
namespace {

/// Where the points of strands are set, about the axis: unit vectors, evenly spread, in an order that has any few in a
/// row point all ways.
class SectionOffsets {
 public:
  SectionOffsets() {
    constexpr double kGolden = 2.399963229728653;  // radians
    for (int i = 0; i < kCount; ++i) {
      const int shuffled = i * kStride % kCount;
      const double z = 1 - (2 * shuffled + 1.0) / kCount, radius = std::sqrt(1 - z * z), angle = kGolden * shuffled;
      offsets_[i] = Float32x4{static_cast<float>(radius * std::cos(angle)),
                              static_cast<float>(radius * std::sin(angle)), static_cast<float>(z), 0};
    }
  }
  Float32x4 operator[](size_t i) const { return offsets_[i % kCount]; }

 private:
  static constexpr int kCount = 64, kStride = 25;
  std::array<Float32x4, kCount> offsets_;
};

uint64_t when(size_t point, float share) {
  return static_cast<uint64_t>(point) << 32 | std::bit_cast<uint32_t>(share);
}

}  // namespace

void LeafFiller::fill(const CellStrands& strands, System system, const VoxelGrid& grid, MomentLevel& leaves) {
  const VoxelFrame frame(system, grid);
  reset(strands, system, frame, grid, leaves);
  for (const CellStrands::Strand& strand : strands.strands) {
    sumUp(strands, strand, system);
    for (const float side : {-1.0f, 1.0f}) {
      measure(strands, strand, side, system, frame);
      for (int axis = 0; axis < 3; ++axis) findCrossings(axis, leaves.offsets(axis).data());
      follow(strand, leaves);
    }
  }
}

void LeafFiller::reset(const CellStrands& strands, System system, const VoxelFrame& frame, const VoxelGrid& grid,
                       MomentLevel& leaves) {
  if (strands.points.empty()) return leaves.reset(grid);
  const Float32x4 reach = Float32x4{} + 1.1f * strands.fibreRadius_mm;
  Float32x4 low = toCloth(strands.points[0], system), high = low;
  for (const glm::vec3& p : strands.points) {
    const Float32x4 point = toCloth(p, system);
    low = least(low, point - reach);
    high = most(high, point + reach);
  }
  const Int32x4 a = VoxelFrame::voxelOf(frame(low)), b = VoxelFrame::voxelOf(frame(high));
  leaves.reset(grid, frame.first() + glm::ivec3(a[0], a[1], a[2]), frame.first() + glm::ivec3(b[0], b[1], b[2]),
               frame.first(), strands.fibreRadius_mm);
}

void LeafFiller::sumUp(const CellStrands& strands, const CellStrands::Strand& strand, System system) {
  sums_.resize(strand.count);
  FibreMoments* const sums = sums_.data();
  const glm::vec3* const source = strands.points.data() + strand.first;
  const double share = 0.5 * strands.fibresEach;  // each of its two lines has half
  Float64x4 end = __builtin_convertvector(toCloth(source[0], system), Float64x4);
  FibreMoments sum;
  sums[0] = sum;
  for (size_t i = 1; i < strand.count; ++i) {
    const Float64x4 start = std::exchange(end, __builtin_convertvector(toCloth(source[i], system), Float64x4));
    sum.add(FibreMoments::ofSegment(end - start), share);
    sums[i] = sum;
  }
}

void LeafFiller::measure(const CellStrands& strands, const CellStrands::Strand& strand, float side, System system,
                         VoxelFrame frame) {
  const size_t count = strand.count;
  points_.resize(count);
  Point* const points = points_.data();
  const glm::vec3* const source = strands.points.data() + strand.first;
  // A fibre has a section, and its length is spread over it: by lines that waver across it, at a distance from the axis
  // that gives them the second moment of the section, r^2 / 4 across each way. The points of a line lie on a sphere, so
  // a third of that is along the fibre, and what lies between two points is nearer to the axis by another third.
  static const SectionOffsets offsets;
  const Float32x4 radius = Float32x4{} + std::sqrt(9.0f / 8.0f) * strands.fibreRadius_mm * side;
  const auto about = [&](size_t i) { return frame(toCloth(source[i], system) + radius * offsets[strand.first + i]); };
  Float32x4 at = about(0);
  Int32x4 voxel = VoxelFrame::voxelOf(at), crossings{};
  points[0] = {at, Float32x4{}, voxel};
  for (size_t i = 1; i < count; ++i) {
    const Float32x4 from = std::exchange(at, about(i));
    const Int32x4 left = std::exchange(voxel, VoxelFrame::voxelOf(at));
    const Int32x4 upwards = voxel > left;  // -1 where it is so
    const Float32x4 face = __builtin_convertvector(left - upwards, Float32x4);
    points[i] = {at, least(most((face - from) / (at - from), Float32x4{}), Float32x4{} + 1), voxel};
    crossings += magnitude(voxel - left);
  }
  crossingCounts_ = crossings;
}

/// One more at the end is never reached.
void LeafFiller::findCrossings(int axis, const int32_t* offsets) {
  const auto total = static_cast<size_t>(crossingCounts_[axis]);
  if (crossings_[axis].size() <= total) crossings_[axis].resize(2 * total + 1);
  Crossing* next = crossings_[axis].data();
  const Point* const points = points_.data();
  for (size_t i = 1; i < points_.size(); ++i) {
    const int from = points[i - 1].voxel[axis], to = points[i].voxel[axis], count = std::abs(to - from);
    // Most often there is none or one, so one is written in any case.
    *next = {when(i, points[i].firstFace[axis]), offsets[to]};
    if (count > 1) {
      const float perStep = 1 / std::abs(points[i].at[axis] - points[i - 1].at[axis]);
      const int step = to > from ? 1 : -1;
      float share = points[i].firstFace[axis];
      for (int k = 0; k < count; ++k) {
        next[k] = {when(i, std::min(share, 1.0f)), offsets[from + (k + 1) * step]};
        share += perStep;
      }
    }
    next += count;
  }
  *next = {std::numeric_limits<uint64_t>::max(), 0};
}

void LeafFiller::follow(const CellStrands::Strand& strand, MomentLevel& leaves) const {
  const Crossing *x = crossings_[0].data(), *y = crossings_[1].data(), *z = crossings_[2].data();
  const Int32x4 first = points_[0].voxel;
  int32_t ox = leaves.offsets(0)[first[0]], oy = leaves.offsets(1)[first[1]], oz = leaves.offsets(2)[first[2]];
  const FibreMoments* const sums = sums_.data();
  const Point* const points = points_.data();
  Float64x4 squares{}, others{};  // of the strand up to where it came into the voxel
  Float32x4 cameIn = points[0].at;
  for (int left = crossingCounts_[0] + crossingCounts_[1] + crossingCounts_[2]; left > 0; --left) {
    const MomentLevel::Fibres here = leaves.at(ox + oy + oz, strand.ply);
    const uint64_t next = std::min(x->when, std::min(y->when, z->when));
    const size_t point = next >> 32;
    const FibreMoments &to = sums[point], &from = *(&to - 1);
    const float partOf = std::bit_cast<float>(static_cast<uint32_t>(next));
    const double share = partOf;
    const Float64x4 nowSquares = from.squares + share * (to.squares - from.squares);
    const Float64x4 nowOthers = from.others + share * (to.others - from.others);
    here.moments.squares += nowSquares - squares;
    here.moments.others += nowOthers - others;
    const Float32x4 before = points[point - 1].at, goesOut = before + partOf * (points[point].at - before);
    here.bounds.add(cameIn);
    here.bounds.add(goesOut);
    cameIn = goesOut;
    squares = nowSquares;
    others = nowOthers;
    const bool isX = x->when == next, isY = !isX & (y->when == next), isZ = !isX & !isY;
    ox = isX ? x->offset : ox;
    oy = isY ? y->offset : oy;
    oz = isZ ? z->offset : oz;
    x += isX;
    y += isY;
    z += isZ;
  }
  const MomentLevel::Fibres last = leaves.at(ox + oy + oz, strand.ply);
  last.moments.squares += sums[strand.count - 1].squares - squares;
  last.moments.others += sums[strand.count - 1].others - others;
  last.bounds.add(cameIn);
  last.bounds.add(points[strand.count - 1].at);
}

}  // namespace loomlight
