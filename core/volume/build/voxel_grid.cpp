#include "core/volume/build/voxel_grid.h"

#include <cmath>

namespace loomlight {

int VoxelGrid::levels() const {
  int levels = 1;
  while (atLevel(levels - 1).perCell() != glm::ivec3(1)) ++levels;
  return levels;
}

double VoxelGrid::volume_mm3(glm::ivec3 voxel) const {
  const glm::ivec3 voxels = perCell();
  double volume = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int inCell = (voxel[axis] % voxels[axis] + voxels[axis]) % voxels[axis];
    volume *= extent_mm(axis, inCell);
  }
  return volume;
}

VoxelGrid makeGrid(const ClothGeometry& geometry, int resolution) {
  const double x = geometry.warpPitch_mm(), y = geometry.weftPitch_mm(), z = 2 * geometry.halfThickness_mm();
  const auto across = [](double length, double leaf) { return std::max(1.0, std::round(length / leaf)); };
  const auto layers = [z](double leaf) { return std::max(1.0, std::ceil(z / leaf)); };
  // A voxel narrower than a fibre holds one alone, and light would meet again the very fibre that it leaves.
  constexpr int kFinestRegardless = 8;
  const double diameter = geometry.minYarnDiameter_mm();
  const double finest = std::min(2 * geometry.yarns().minFibreRadius_mm(), diameter / kFinestRegardless);
  double leaf = std::max(diameter / std::max(1, resolution), finest);
  while (across(x, leaf) * across(y, leaf) * layers(leaf) > kMaxCellVoxels) leaf *= 1.125;

  VoxelGrid grid;
  const glm::dvec3 cell(across(x, leaf), across(y, leaf), layers(leaf));
  grid.cell = glm::ivec3(cell);
  grid.size_mm = glm::vec3(x / cell.x, y / cell.y, leaf);
  grid.zLower_mm = static_cast<float>(-0.5 * leaf * cell.z);
  return grid;
}

}  // namespace loomlight
