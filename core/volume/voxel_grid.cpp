#include "core/volume/voxel_grid.h"

#include <cmath>

namespace loomlight {
namespace {

/// Leaves that voxel i of a level spans in an axis of `cell` leaves.
int leavesAcross(int i, int level, int cell) {
  const int perCell = (cell + (1 << level) - 1) >> level;
  const int inCell = ((i % perCell) + perCell) % perCell;
  return std::min((inCell + 1) << level, cell) - (inCell << level);
}

}  // namespace

double VoxelGrid::volume_mm3(glm::ivec3 v, int level) const {
  double volume = static_cast<double>(size_mm.x) * size_mm.y * size_mm.z;
  volume *= leavesAcross(v.x, level, cell.x);
  volume *= leavesAcross(v.y, level, cell.y);
  return volume * leavesAcross(v.z, level, cell.z);
}

VoxelGrid makeGrid(const ClothGeometry& geometry, int resolution) {
  const double x = geometry.warpPitch_mm(), y = geometry.weftPitch_mm(), z = 2 * geometry.halfThickness_mm();
  const auto across = [](double length, double leaf) { return std::max(1.0, std::round(length / leaf)); };
  const auto layers = [z](double leaf) { return std::max(1.0, std::ceil(z / leaf)); };
  double leaf = geometry.minYarnDiameter_mm() / std::max(1, resolution);
  while (across(x, leaf) * across(y, leaf) * layers(leaf) > kMaxCellVoxels) leaf *= 1.125;

  VoxelGrid grid;
  const glm::dvec3 cell(across(x, leaf), across(y, leaf), layers(leaf));
  grid.cell = glm::ivec3(cell);
  grid.size_mm = glm::vec3(x / cell.x, y / cell.y, leaf);
  grid.zLower_mm = static_cast<float>(-0.5 * leaf * cell.z);
  while (grid.cellAt(grid.levels - 1) != glm::ivec3(1)) ++grid.levels;
  return grid;
}

}  // namespace loomlight
