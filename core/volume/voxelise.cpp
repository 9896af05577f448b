#include "core/volume/voxelise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/volume/moment_level.h"

namespace loomlight {
namespace {

/// x, y, z, and a lane that is not used.
FloatLanes toLanes(const glm::vec3& p) {
  return FloatLanes{p.x, p.y, p.z, 0};
}

/// From the yarn's frame (u, s, z) to the axes of the cloth: warp (s, u) = (+y, +x), weft (s, u) = (+x, -y).
FloatLanes toCloth(const glm::vec3& usz, System system) {
  return system == System::warp ? toLanes(usz) : FloatLanes{usz.y, -usz.x, usz.z, 0};
}

/// Where points lie in the voxels of their brick, counted from the lower corner of all cells that it may reach into, so
/// that no coordinate is negative: a yarn's cell is its own along it, and reaches into the cells beside it across.
/// Points on the far faces, and what rounding puts beyond, count as inside.
class VoxelFrame {
 public:
  VoxelFrame(System system, const VoxelGrid& grid) {
    const int across = system == System::warp ? 0 : 1;
    glm::vec3 end(grid.cell);
    first_[across] = -grid.cell[across];
    end[across] *= 3;
    const glm::vec3 perMm = 1.0f / grid.size_mm;
    glm::vec3 origin = glm::vec3(0.5f, 0.5f, 0) * glm::vec3(grid.cell) - glm::vec3(first_);
    origin.z = -grid.zLower_mm * perMm.z;
    for (int axis = 0; axis < 3; ++axis) end[axis] = std::nextafter(end[axis], -1.0f);
    perMm_ = toLanes(perMm);
    origin_ = toLanes(origin);
    upper_ = toLanes(end);
  }
  /// Of a point in mm, in the axes of the cloth.
  FloatLanes operator()(FloatLanes point) const {
    const FloatLanes p = origin_ + point * perMm_;
    const FloatLanes atLeast = p > 0 ? p : FloatLanes{};
    return atLeast < upper_ ? atLeast : upper_;
  }
  /// The voxel at the lower corner.
  glm::ivec3 first() const { return first_; }

 private:
  glm::ivec3 first_{0};
  FloatLanes perMm_{}, origin_{}, upper_{};
};

/// Follows the fibres of a yarn through the voxels of its brick, and leaves in each the moments of what lies there.
///
/// Where a strand crosses faces is found axis by axis, then the three lists are merged, and what lies between two
/// crossings is the difference of two sums along the strand. So there are no branches but those of long, even loops:
/// how many voxels a segment crosses is what a processor cannot predict.
class LeafFiller {
 public:
  LeafFiller(const CellStrands& strands, System system, const VoxelGrid& grid)
      : strands_(strands), system_(system), frame_(system, grid), leaves_(makeLeaves(grid)) {}

  MomentLevel fill() && {
    for (const CellStrands::Strand& strand : strands_.strands) {
      measure(strand);
      for (int axis = 0; axis < 3; ++axis) findCrossings(strand, axis);
      follow(strand);
    }
    return std::move(leaves_);
  }

 private:
  /// A strand comes to another voxel.
  struct Crossing {
    uint64_t when;   ///< number of the next point, and bits of how far to it, 0..1: in order along the strand
    int32_t offset;  ///< in this axis, of the voxel it comes to: MomentLevel::offset
  };
  MomentLevel makeLeaves(const VoxelGrid& grid) {
    if (strands_.points.empty()) return MomentLevel(grid);
    glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const glm::vec3& p : strands_.points) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    const IntLanes a = voxelOf(frame_(toCloth(low, system_))), b = voxelOf(frame_(toCloth(high, system_)));
    glm::ivec3 first, last;
    for (int axis = 0; axis < 3; ++axis) {
      first[axis] = std::min(a[axis], b[axis]);
      last[axis] = std::max(a[axis], b[axis]);
    }
    MomentLevel leaves(grid, frame_.first() + first, frame_.first() + last);
    for (int axis = 0; axis < 3; ++axis)
      for (int v = 0; v <= last[axis]; ++v) offsets_[axis].push_back(leaves.offset(axis, frame_.first()[axis] + v));
    return leaves;
  }

  static IntLanes voxelOf(FloatLanes p) { return __builtin_convertvector(p, IntLanes); }

  /// What is found at the points of a strand, from its first one on.
  void measure(const CellStrands::Strand& strand) {
    const size_t count = strand.count;
    if (at_.size() < count) {
      at_.resize(count);
      voxels_.resize(count);
      firstFaces_.resize(count);
      sums_.resize(count);
    }
    const VoxelFrame frame = frame_;
    const System system = system_;
    const double packing = strand.packing;
    const glm::vec3* const points = strands_.points.data() + strand.first;
    FloatLanes point = toCloth(points[0], system), a = frame(point);
    IntLanes voxel = voxelOf(a);
    FibreMoments sum;
    at_[0] = a;
    voxels_[0] = voxel;
    sums_[0] = sum;
    for (size_t i = 1; i < count; ++i) {
      const FloatLanes from = std::exchange(point, toCloth(points[i], system));
      const Lanes along = __builtin_convertvector(point, Lanes) - __builtin_convertvector(from, Lanes);
      sum.add(FibreMoments::ofSegment(along, packing));
      const FloatLanes b = frame(point);
      const IntLanes to = voxelOf(b);
      const IntLanes upwards = to > voxel;  // -1 where it is so
      const FloatLanes t = (__builtin_convertvector(voxel - upwards, FloatLanes) - a) / (b - a);
      const FloatLanes above = t > 0 ? t : FloatLanes{};
      firstFaces_[i] = above < 1 ? above : FloatLanes{} + 1;
      at_[i] = a = b;
      voxels_[i] = voxel = to;
      sums_[i] = sum;
    }
  }

  /// The crossings of faces across an axis, in order; one more at the end that is never reached.
  void findCrossings(const CellStrands::Strand& strand, int axis) {
    std::vector<Crossing>& list = crossings_[axis];
    const int32_t* const offsets = offsets_[axis].data();
    size_t used = 0;
    for (uint32_t i = 1; i < strand.count; ++i) {
      const int from = voxels_[i - 1][axis], to = voxels_[i][axis], count = std::abs(to - from);
      if (used + static_cast<size_t>(count) + 2 > list.size()) list.resize(2 * (used + count) + 64);
      // Most often there is none or one, so one is written in any case.
      list[used] = {when(i, firstFaces_[i][axis]), offsets[to]};
      if (count > 1) {
        const float first = firstFaces_[i][axis], perStep = 1 / std::abs(at_[i][axis] - at_[i - 1][axis]);
        const int step = to > from ? 1 : -1;
        for (int k = 0; k < count; ++k)
          list[used + k] = {when(i, std::min(first + static_cast<float>(k) * perStep, 1.0f)),
                            offsets[from + (k + 1) * step]};
      }
      used += static_cast<size_t>(count);
    }
    list[used] = {std::numeric_limits<uint64_t>::max(), 0};
    counts_[axis] = used;
  }

  static uint64_t when(uint32_t point, float share) { return uint64_t{point} << 32 | std::bit_cast<uint32_t>(share); }
  void follow(const CellStrands::Strand& strand) {
    const Crossing *x = crossings_[0].data(), *y = crossings_[1].data(), *z = crossings_[2].data();
    int32_t ox = offsets_[0][voxels_[0][0]], oy = offsets_[1][voxels_[0][1]], oz = offsets_[2][voxels_[0][2]];
    const FibreMoments* const sums = sums_.data();
    FibreMoments before;
    const auto leave = [&](const FibreMoments& now) {
      FibreMoments& here = leaves_.at(ox + oy + oz, strand.ply, strand.material);
      here.squares += now.squares - before.squares;
      here.others += now.others - before.others;
      before = now;
    };
    for (size_t left = counts_[0] + counts_[1] + counts_[2]; left > 0; --left) {
      const uint64_t next = std::min(x->when, std::min(y->when, z->when));
      const FibreMoments &to = sums[next >> 32], &from = *(&to - 1);
      const double share = std::bit_cast<float>(static_cast<uint32_t>(next));
      leave({from.squares + share * (to.squares - from.squares), from.others + share * (to.others - from.others)});
      const bool isX = x->when == next, isY = !isX & (y->when == next), isZ = !isX & !isY;
      ox = isX ? x->offset : ox;
      oy = isY ? y->offset : oy;
      oz = isZ ? z->offset : oz;
      x += isX;
      y += isY;
      z += isZ;
    }
    leave(sums[strand.count - 1]);
  }

  const CellStrands& strands_;
  System system_;
  VoxelFrame frame_;
  std::array<std::vector<int32_t>, 3> offsets_;  ///< MomentLevel::offset by coordinate in the frame
  MomentLevel leaves_;
  // Of the strand that is followed, by its points:
  std::vector<FloatLanes> at_;  ///< in the frame
  std::vector<IntLanes> voxels_;
  std::vector<FloatLanes> firstFaces_;  ///< where the segment to it first meets a face across an axis, 0..1
  std::vector<FibreMoments> sums_;      ///< from the first one on
  std::array<std::vector<Crossing>, 3> crossings_;
  std::array<size_t, 3> counts_{};
};

}  // namespace

Brick voxelise(const CellStrands& strands, System system, const VoxelGrid& grid) {
  std::vector<Brick::Level> levels;
  levels.reserve(grid.levels);
  MomentLevel level = LeafFiller(strands, system, grid).fill();
  levels.push_back(level.fit());
  while (static_cast<int>(levels.size()) < grid.levels) {
    level = level.coarser();
    levels.push_back(level.fit());
  }
  return {std::move(levels), strands.segments()};
}

}  // namespace loomlight
