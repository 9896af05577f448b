#pragma once

// The traversal of ClothVolume, apart from its declaration; included by cloth_volume.h.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/volume/cloth_volume.h"

namespace loomlight {

inline void ClothVolume::gather(System system, int across, int along, int level, Reaches& reaches) const {
  const TileMap& tiles = tiles_[static_cast<int>(system)];
  const int axis = system == System::warp ? 0 : 1;
  const auto add = [&](const TileMap::Slot& slot, int neighbour) {
    Reach& reach = reaches.entries[reaches.count++];
    reach.level = &slot.brick->level(level);
    reach.shift = glm::ivec3(0);
    reach.shift[axis] = -neighbour * grid_.cellAt(level)[axis];
    reach.system = system;
    reach.index = across + neighbour;
  };
  add(tiles.at(across, along), 0);
  if (tiles.anyReachesAbove() && across > 0) {
    const TileMap::Slot& slot = tiles.at(across - 1, along);
    if (slot.reachesAbove) add(slot, -1);
  }
  if (tiles.anyReachesBelow() && across + 1 < cells_[axis]) {
    const TileMap::Slot& slot = tiles.at(across + 1, along);
    if (slot.reachesBelow) add(slot, 1);
  }
}

inline void ClothVolume::gather(int pick, int end, int level, Reaches& reaches) const {
  reaches.count = 0;
  gather(System::warp, end, pick, level, reaches);
  gather(System::weft, pick, end, level, reaches);
}

inline void ClothVolume::look(const Reaches& reaches, glm::ivec3 voxelInCell, VoxelContent& content) {
  int count = 0;
  for (int i = 0; i < reaches.count; ++i) {
    const Reach& reach = reaches.entries[i];
    const std::span<const Component> components = reach.level->at(voxelInCell + reach.shift);
    if (components.empty()) continue;
    content.parts[count++] = {components, reach.system, reach.index};
  }
  content.count = count;
}

template <class Visit>
bool ClothVolume::march(glm::vec3 origin, glm::vec3 direction, float t0, float t1, Visit&& visit, int level) const {
  // In double: at the far side of a wide cloth a float's step is no longer small beside a voxel.
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(t0 < t1) || !std::isfinite(glm::dot(origin, glm::vec3(1)) + glm::dot(direction, glm::vec3(1)))) return true;
  const glm::dvec3 o(origin.x, origin.y, static_cast<double>(origin.z) - grid_.zLower_mm), d(direction);
  const glm::dvec3 size = cell_mm_ * glm::dvec3(cells_);
  glm::dvec3 inverse(0), tNext(kInfinity);
  double t = std::max(t0, std::numeric_limits<float>::lowest()), tEnd = t1;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) {
      if (!(o[axis] >= 0 && o[axis] < size[axis])) return true;
      continue;
    }
    inverse[axis] = 1 / d[axis];
    const double a = -o[axis] * inverse[axis], b = (size[axis] - o[axis]) * inverse[axis];
    t = std::max(t, std::min(a, b));
    tEnd = std::min(tEnd, std::max(a, b));
  }
  if (!(t < tEnd)) return true;

  const glm::ivec3 perCell = grid_.cellAt(level);
  glm::ivec3 cell, voxel;  // voxel: of the level, in its cell
  glm::dvec3 inCell;       // the origin, from the corner of the current cell
  const auto enterCell = [&](int axis) { inCell[axis] = o[axis] - cell[axis] * cell_mm_[axis]; };
  const auto nextFace = [&](int axis) {
    const int leaf = d[axis] > 0 ? std::min((voxel[axis] + 1) << level, grid_.cell[axis]) : voxel[axis] << level;
    return (leaf * voxel_mm_[axis] - inCell[axis]) * inverse[axis];
  };
  for (int axis = 0; axis < 3; ++axis) {
    const double start = o[axis] + t * d[axis];
    cell[axis] = std::clamp(static_cast<int>(start / cell_mm_[axis]), 0, cells_[axis] - 1);
    enterCell(axis);
    const double leaf = (start - cell[axis] * cell_mm_[axis]) / voxel_mm_[axis];
    voxel[axis] = std::clamp(static_cast<int>(leaf), 0, grid_.cell[axis] - 1) >> level;
    if (d[axis] != 0) tNext[axis] = nextFace(axis);
  }

  VoxelContent content;
  Reaches reaches;
  content.end = cell.x;
  content.pick = cell.y;
  gather(cell.y, cell.x, level, reaches);
  for (;;) {
    int axis = tNext.y < tNext.x ? 1 : 0;
    if (tNext.z < tNext[axis]) axis = 2;
    const double tLeave = std::min(tNext[axis], tEnd);
    // A step of no length is that of a ray through an edge, or one that starts on a face.
    if (tLeave > t) {
      look(reaches, voxel, content);
      const auto enter = static_cast<float>(t), leave = static_cast<float>(tLeave);
      if (content.count > 0 && enter < leave) {
        content.voxel = cell * perCell + voxel;
        if (!visit(static_cast<const VoxelContent&>(content), enter, leave)) return false;
      }
      t = tLeave;
    }
    if (!(tNext[axis] < tEnd)) return true;
    const int step = d[axis] > 0 ? 1 : -1;
    voxel[axis] += step;
    if (static_cast<unsigned>(voxel[axis]) >= static_cast<unsigned>(perCell[axis])) {
      cell[axis] += step;
      if (static_cast<unsigned>(cell[axis]) >= static_cast<unsigned>(cells_[axis])) return true;
      voxel[axis] = step > 0 ? 0 : perCell[axis] - 1;
      enterCell(axis);
      content.end = cell.x;
      content.pick = cell.y;
      gather(cell.y, cell.x, level, reaches);
    }
    tNext[axis] = nextFace(axis);
  }
}

}  // namespace loomlight
