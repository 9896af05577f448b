#include "core/volume/moment_level.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/volume/component_encoder.h"

namespace loomlight {
namespace {

int floorDivide(int a, int b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// The cell that a block (or voxel) lies in, -1, 0 or 1 across, and its place there.
struct Place {
  glm::ivec3 cell, inCell;
};
Place placeOf(glm::ivec3 block, glm::ivec3 perCell) {
  const glm::ivec3 cell(floorDivide(block.x, perCell.x), floorDivide(block.y, perCell.y), 0);
  return {cell, block - cell * perCell};
}

/// The block of a leaf voxel.
glm::ivec3 blockOf(glm::ivec3 voxel, glm::ivec3 perCell) {
  const Place place = placeOf(voxel, perCell);
  return place.cell * ((perCell + 3) >> 2) + (place.inCell >> 2);
}

/// Blocks of the cells of a level.
glm::ivec3 blocksPerCell(const VoxelGrid& grid, int level) {
  return (grid.cellAt(level) + 3) >> 2;
}

/// Of a voxel's number in its block, that of the coarser voxel it lies in, from the first voxel of its block on.
constexpr std::array<uint8_t, 64> makeHalved() {
  std::array<uint8_t, 64> halved{};
  for (int i = 0; i < 64; ++i) halved[i] = static_cast<uint8_t>((i & 3) >> 1 | (i >> 2 & 3) >> 1 << 2 | i >> 5 << 4);
  return halved;
}
constexpr auto kHalved = makeHalved();

/// The moments of one ply in a voxel, or of several that had to be merged.
struct Part {
  FibreMoments moments;
  uint8_t ply, material;
};

/// Merges the most alike until two are left; the longer names the material.
void mergeToTwo(std::vector<Part>& parts) {
  while (parts.size() > 2) {
    size_t first = 0, second = 1;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < parts.size(); ++i) {
      for (size_t j = i + 1; j < parts.size(); ++j) {
        const double cost = mergeCost(parts[i].moments, parts[j].moments);
        if (cost < least) {
          least = cost;
          first = i;
          second = j;
        }
      }
    }
    if (parts[second].moments.length_mm() > parts[first].moments.length_mm())
      parts[first].material = parts[second].material;
    parts[first].moments.add(parts[second].moments);
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(second));
  }
}

}  // namespace

MomentLevel::MomentLevel(const VoxelGrid& grid, int level, glm::ivec3 lower, glm::ivec3 blocks)
    : grid_(grid),
      level_(level),
      perCell_(blocksPerCell(grid, level)),
      lower_(lower),
      blocks_(blocks),
      occupied_(static_cast<size_t>(blocks.x) * blocks.y * blocks.z, 0),
      heads_(64 * occupied_.size(), -1) {
  const size_t room = std::min<size_t>(heads_.size() / 4, 4096);  // about what is occupied
  links_.reserve(room);
  moments_.reserve(room);
}

MomentLevel::MomentLevel(const VoxelGrid& grid, glm::ivec3 first, glm::ivec3 last)
    : MomentLevel(grid, 0, blockOf(first, grid.cell), blockOf(last, grid.cell) + 1 - blockOf(first, grid.cell)) {}

int32_t MomentLevel::offset(int axis, int v) const {
  const int cell = grid_.cellAt(level_)[axis], inCell = v - floorDivide(v, cell) * cell;
  const int block = floorDivide(v, cell) * perCell_[axis] + (inCell >> 2) - lower_[axis];
  const int stride[] = {1, blocks_.x, blocks_.x * blocks_.y};
  return 64 * block * stride[axis] + ((inCell & 3) << (2 * axis));
}

glm::ivec3 MomentLevel::blockAt(size_t number) const {
  const int n = static_cast<int>(number);
  return lower_ + glm::ivec3(n % blocks_.x, n / blocks_.x % blocks_.y, n / (blocks_.x * blocks_.y));
}

FibreMoments& MomentLevel::append(int32_t voxel, uint8_t ply, uint8_t material) {
  links_.push_back({heads_[voxel], ply, material});
  heads_[voxel] = static_cast<int32_t>(moments_.size());
  occupied_[voxel >> 6] |= uint64_t{1} << (voxel & 63);
  return moments_.emplace_back();
}

MomentLevel MomentLevel::coarser() const {
  const glm::ivec3 parentsPerCell = blocksPerCell(grid_, level_ + 1);
  const auto parentOf = [&](glm::ivec3 block) {
    const Place place = placeOf(block, perCell_);
    return place.cell * parentsPerCell + (place.inCell >> 1);
  };
  const glm::ivec3 lower = parentOf(lower_), last = parentOf(lower_ + blocks_ - 1);
  MomentLevel result(grid_, level_ + 1, lower, occupied_.empty() ? glm::ivec3(0) : last + 1 - lower);
  for (size_t number = 0; number < occupied_.size(); ++number) {
    if (occupied_[number] == 0) continue;
    // The block is an octant of its parent.
    const glm::ivec3 block = blockAt(number), p = parentOf(block) - lower, octant = placeOf(block, perCell_).inCell & 1;
    const int parent = (p.z * result.blocks_.y + p.y) * result.blocks_.x + p.x;
    const int first = 64 * parent + 2 * (octant.x + 4 * octant.y + 16 * octant.z);
    for (uint64_t rest = occupied_[number]; rest != 0; rest &= rest - 1) {
      const int voxel = std::countr_zero(rest);
      for (int32_t i = heads_[64 * number + voxel]; i >= 0; i = links_[i].next)
        result.at(first + kHalved[voxel], links_[i].ply, links_[i].material).add(moments_[i]);
    }
  }
  return result;
}

Brick::Level MomentLevel::fit() const {
  Brick::Level result;
  result.cell = grid_.cellAt(level_);
  result.lower = lower_;
  result.blocks = blocks_;
  result.grid.resize(occupied_.size());
  std::array<std::vector<double>, 3> extents_mm;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < result.cell[axis]; ++i) extents_mm[axis].push_back(grid_.extent_mm(axis, i, level_));

  ComponentEncoder encoder;
  std::vector<int32_t> voxels;  // of each component
  std::vector<Part> parts;
  for (size_t number = 0; number < occupied_.size(); ++number) {
    if (occupied_[number] == 0) continue;
    const glm::ivec3 corner = 4 * placeOf(blockAt(number), perCell_).inCell;
    for (uint64_t rest = occupied_[number]; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      const auto voxel = static_cast<int32_t>(64 * number + bit);
      const double volume = extents_mm[0][corner.x + (bit & 3)] * extents_mm[1][corner.y + (bit >> 2 & 3)] *
                            extents_mm[2][corner.z + (bit >> 4)];
      parts.clear();
      for (int32_t i = heads_[voxel]; i >= 0; i = links_[i].next)
        if (moments_[i].length_mm() > 0) parts.push_back({moments_[i], links_[i].ply, links_[i].material});
      if (parts.size() > 1) {
        std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
          return std::tie(a.ply, a.material) < std::tie(b.ply, b.material);
        });
        mergeToTwo(parts);
      }
      for (const Part& part : parts) {
        encoder.add(part.moments, volume, part.material);
        voxels.push_back(voxel);
      }
    }
  }

  const std::vector<Component> components = encoder.take();
  result.components.reserve(components.size());
  int last = -1;
  for (size_t i = 0; i < components.size(); ++i) {
    if (components[i].lengthDensity() == 0) continue;
    Brick::Block& block = result.grid[voxels[i] >> 6];
    const uint64_t bit = uint64_t{1} << (voxels[i] & 63);
    if (voxels[i] >> 6 != last) block.first = static_cast<uint32_t>(result.components.size());
    last = voxels[i] >> 6;
    (block.occupied & bit ? block.second : block.occupied) |= bit;
    result.components.push_back(components[i]);
  }
  result.components.shrink_to_fit();
  return result;
}

}  // namespace loomlight
