#pragma once

#include <cmath>

#include "core/base/simd.h"
#include "core/geometry/yarn/cell_strands.h"
#include "core/volume/build/voxel_grid.h"

namespace loomlight {

/// From the yarn's frame (u, s, z) to the axes of the cloth: warp (s, u) = (+y, +x), weft (s, u) = (+x, -y). The last
/// lane is 0.
inline Float32x4 toCloth(const glm::vec3& usz, System system) {
  return system == System::warp ? Float32x4{usz.x, usz.y, usz.z, 0} : Float32x4{usz.y, -usz.x, usz.z, 0};
}

/// Where points lie in the voxels of their brick, counted from the lower corner of all cells that it may reach into, so
/// that no coordinate is negative: a yarn's cell is its own along it, and reaches into the cells beside it across.
/// Points on the far faces, and what rounding puts beyond, count as inside.
class VoxelFrame {
 public:
  VoxelFrame(System system, const VoxelGrid& grid) {
    const int across = system == System::warp ? 0 : 1;
    const auto halfCell = [&](int axis) { return 0.5f * static_cast<float>(grid.cell[axis]); };
    first_[across] = -grid.cell[across];
    perMm_ = Float32x4{1 / grid.size_mm.x, 1 / grid.size_mm.y, 1 / grid.size_mm.z, 0};
    origin_ = Float32x4{halfCell(0), halfCell(1), -grid.zLower_mm * perMm_[2], 0};
    origin_[across] += static_cast<float>(grid.cell[across]);
    for (int axis = 0; axis < 3; ++axis)
      upper_[axis] = std::nextafter(static_cast<float>(grid.cell[axis] * (axis == across ? 3 : 1)), 0.0f);
  }

  /// Of a point in mm, in the axes of the cloth. The last lane is 0.
  Float32x4 operator()(Float32x4 point) const { return least(most(origin_ + point * perMm_, Float32x4{}), upper_); }
  static Int32x4 voxelOf(Float32x4 at) { return __builtin_convertvector(at, Int32x4); }
  /// The voxel at the lower corner.
  glm::ivec3 first() const { return first_; }

 private:
  glm::ivec3 first_{0};
  Float32x4 perMm_{}, origin_{}, upper_{};
};

}  // namespace loomlight
