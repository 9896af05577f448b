#include "core/volume/voxelise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/volume/moment_level.h"

namespace loomlight {
namespace {

/// From the yarn's frame (u, s, z) to the axes of the cloth: warp (s, u) = (+y, +x), weft (s, u) = (+x, -y).
template <class Vector>
Vector toCloth(const Vector& usz, System system) {
  return system == System::warp ? usz : Vector(usz.y, -usz.x, usz.z);
}

/// Where points lie in the voxels of their brick. Points on the far faces, and what rounding puts beyond, count as
/// inside: a yarn's cell is its own along it, and reaches into the cells beside it across.
class VoxelFrame {
 public:
  VoxelFrame(System system, const VoxelGrid& grid) : system_(system) {
    const glm::vec3 cell(grid.cell);
    perMm_ = 1.0f / grid.size_mm;
    origin_ = {0.5f * cell.x, 0.5f * cell.y, -grid.zLower_mm * perMm_.z};
    glm::vec3 first(0), end = cell;
    (system == System::warp ? first.x : first.y) -= system == System::warp ? cell.x : cell.y;
    (system == System::warp ? end.x : end.y) += system == System::warp ? cell.x : cell.y;
    lower_ = first;
    for (int axis = 0; axis < 3; ++axis) upper_[axis] = std::nextafter(end[axis], -1.0f);
  }
  glm::vec3 operator()(glm::vec3 usz) const {
    return glm::clamp(origin_ + toCloth(usz, system_) * perMm_, lower_, upper_);
  }

 private:
  System system_;
  glm::vec3 perMm_{1}, origin_{0}, lower_{0}, upper_{0};
};

glm::ivec3 floorOf(glm::vec3 p) {
  return {static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)), static_cast<int>(std::floor(p.z))};
}

/// Gives each voxel from that of a to that of b its share of the segment: deposit(index, fraction), fractions in order,
/// adding up to 1. The number of steps is known beforehand, so rounding can neither lose the end nor run past it.
template <class Deposit>
void clipSegment(glm::vec3 a, glm::vec3 b, glm::ivec3 va, glm::ivec3 vb, int64_t index, glm::i64vec3 strides,
                 Deposit&& deposit) {
  const glm::vec3 d = b - a;
  glm::vec3 tNext(std::numeric_limits<float>::infinity()), tStep(0);
  int64_t stride[3];
  int steps = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = vb[axis] - va[axis];
    stride[axis] = cells < 0 ? -strides[axis] : strides[axis];
    if (cells == 0) continue;
    steps += std::abs(cells);
    const float inverse = 1.0f / d[axis];
    tStep[axis] = std::abs(inverse);
    tNext[axis] = (static_cast<float>(va[axis] + (cells > 0 ? 1 : 0)) - a[axis]) * inverse;
  }
  float t = 0;
  for (; steps > 0; --steps) {
    int axis = tNext.y < tNext.x ? 1 : 0;
    if (tNext.z < tNext[axis]) axis = 2;
    const float next = std::min(tNext[axis], 1.0f);
    if (next > t) {
      deposit(index, next - t);
      t = next;
    }
    index += stride[axis];
    tNext[axis] += tStep[axis];
  }
  if (t < 1) deposit(index, 1 - t);
}

}  // namespace

Brick voxelise(const CellStrands& strands, System system, const VoxelGrid& grid) {
  const VoxelFrame frame(system, grid);
  std::vector<glm::vec3> points(strands.points.size());
  glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (size_t i = 0; i < points.size(); ++i) {
    points[i] = frame(strands.points[i]);
    low = glm::min(low, points[i]);
    high = glm::max(high, points[i]);
  }
  const glm::ivec3 lower = points.empty() ? glm::ivec3(0) : floorOf(low);
  const glm::ivec3 extent = points.empty() ? glm::ivec3(0) : floorOf(high) - lower + 1;

  MomentLevel leaves(0, lower, extent);
  const glm::i64vec3 strides = leaves.strides();
  for (const CellStrands::Strand& strand : strands.strands) {
    glm::ivec3 voxel = floorOf(points[strand.first]);
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i) {
      const glm::ivec3 start = voxel;
      voxel = floorOf(points[i + 1]);
      const glm::dvec3 along = glm::dvec3(strands.points[i + 1]) - glm::dvec3(strands.points[i]);
      const FibreMoments segment = FibreMoments::ofSegment(toCloth(along, system), strand.packing);
      const auto deposit = [&](int64_t index, double fraction) {
        leaves.at(index, strand.ply, strand.material).add(segment, fraction);
      };
      if (start == voxel)
        deposit(leaves.indexOf(voxel), 1);
      else
        clipSegment(points[i], points[i + 1], start, voxel, leaves.indexOf(start), strides, deposit);
    }
  }

  std::vector<Brick::Level> levels;
  levels.push_back(leaves.fit(grid));
  for (MomentLevel level = std::move(leaves); static_cast<int>(levels.size()) < grid.levels;) {
    level = level.coarser(grid);
    levels.push_back(level.fit(grid));
  }
  return {std::move(levels), strands.segments()};
}

}  // namespace loomlight
