#include "core/volume/moment_level.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace loomlight {
namespace {

/// The moments of one ply in a voxel, or of several that had to be merged.
struct Part {
  FibreMoments moments;
  uint8_t material;
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

struct Fitted {
  FibreDistribution distribution;
  double volume_mm3;
  int block, bit;  ///< where it goes
};

/// Rounds to components so that their lengths add up to that of the distributions. Longest first: each takes what the
/// one before it lost, and what is lost in the end is the rounding of the shortest.
std::vector<Component> encodeConserving(const std::vector<Fitted>& fitted) {
  std::vector<uint32_t> order(fitted.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto length = [&](uint32_t i) { return fitted[i].distribution.lengthDensity * fitted[i].volume_mm3; };
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return length(a) > length(b); });
  std::vector<Component> components(fitted.size());
  double carry = 0;
  for (const uint32_t i : order) {
    const double own = length(i);
    const double wanted = own + std::clamp(carry, -0.25 * own, 0.25 * own);  // never at the cost of a voxel's truth
    FibreDistribution d = fitted[i].distribution;
    d.lengthDensity = static_cast<float>(wanted / fitted[i].volume_mm3);
    components[i] = Component::encode(d);
    carry += own - components[i].lengthDensity() * fitted[i].volume_mm3;
  }
  return components;
}

int floorDivide(int a, int b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// The voxel of level + 1 that voxel i of a level lies in, along one axis; cells start their voxels anew.
int coarserIndex(int i, int perCell) {
  const int cell = floorDivide(i, perCell);
  return cell * ((perCell + 1) >> 1) + ((i - cell * perCell) >> 1);
}

glm::ivec3 coarserVoxel(glm::ivec3 v, glm::ivec3 perCell) {
  return {coarserIndex(v.x, perCell.x), coarserIndex(v.y, perCell.y), coarserIndex(v.z, perCell.z)};
}

}  // namespace

MomentLevel::MomentLevel(int level, glm::ivec3 lower, glm::ivec3 extent)
    : level_(level), lower_(lower), extent_(extent), heads_(static_cast<size_t>(extent.x) * extent.y * extent.z, -1) {}

FibreMoments& MomentLevel::append(int64_t index, uint8_t ply, uint8_t material) {
  links_.push_back({heads_[index], ply, material});
  heads_[index] = static_cast<int32_t>(moments_.size());
  return moments_.emplace_back();
}

MomentLevel MomentLevel::coarser(const VoxelGrid& grid) const {
  const glm::ivec3 perCell = grid.cellAt(level_);
  const glm::ivec3 lower = coarserVoxel(lower_, perCell);
  const glm::ivec3 upper = coarserVoxel(lower_ + extent_ - 1, perCell) + 1;
  MomentLevel result(level_ + 1, lower, heads_.empty() ? glm::ivec3(0) : upper - lower);
  int64_t index = 0;
  for (int z = 0; z < extent_.z; ++z) {
    for (int y = 0; y < extent_.y; ++y) {
      for (int x = 0; x < extent_.x; ++x, ++index) {
        if (heads_[index] < 0) continue;
        const int64_t parent = result.indexOf(coarserVoxel(lower_ + glm::ivec3(x, y, z), perCell));
        for (int32_t i = heads_[index]; i >= 0; i = links_[i].next)
          result.at(parent, links_[i].ply, links_[i].material).add(moments_[i]);
      }
    }
  }
  return result;
}

Brick::Level MomentLevel::fit(const VoxelGrid& grid) const {
  Brick::Level result;
  result.cell = grid.cellAt(level_);
  const glm::ivec3 perCell = result.blocksPerCell();
  const auto blockOf = [&](glm::ivec3 v) {
    const glm::ivec3 cell(floorDivide(v.x, result.cell.x), floorDivide(v.y, result.cell.y), 0);
    return cell * perCell + ((v - cell * result.cell) >> 2);
  };
  if (!heads_.empty()) {
    result.lower = blockOf(lower_);
    result.blocks = blockOf(lower_ + extent_ - 1) + 1 - result.lower;
  }
  result.grid.resize(static_cast<size_t>(result.blocks.x) * result.blocks.y * result.blocks.z);

  std::vector<Fitted> fitted;
  std::vector<Part> parts;
  std::vector<int32_t> chain;
  const auto byPly = [this](int32_t a, int32_t b) {
    return std::tie(links_[a].ply, links_[a].material) < std::tie(links_[b].ply, links_[b].material);
  };
  for (int block = 0; block < static_cast<int>(result.grid.size()); ++block) {
    const glm::ivec3 b = result.lower + glm::ivec3(block % result.blocks.x, block / result.blocks.x % result.blocks.y,
                                                   block / (result.blocks.x * result.blocks.y));
    const glm::ivec3 cell(floorDivide(b.x, perCell.x), floorDivide(b.y, perCell.y), 0);
    const glm::ivec3 inCell = 4 * (b - cell * perCell), corner = cell * result.cell + inCell;
    // What lies in the block, in its cell, and in the box of the moments.
    const glm::ivec3 first = glm::max(lower_ - corner, 0);
    const glm::ivec3 end = glm::min(glm::min(lower_ + extent_ - corner, result.cell - inCell), 4);
    for (int bit = 0; bit < 64; ++bit) {
      const glm::ivec3 offset(bit & 3, bit >> 2 & 3, bit >> 4), v = corner + offset;
      if (glm::any(glm::lessThan(offset, first)) || glm::any(glm::greaterThanEqual(offset, end))) continue;
      const int32_t head = heads_[indexOf(v)];
      if (head < 0) continue;
      chain.clear();
      for (int32_t i = head; i >= 0; i = links_[i].next)
        if (moments_[i].length_mm() > 0) chain.push_back(i);
      std::sort(chain.begin(), chain.end(), byPly);
      parts.clear();
      for (const int32_t i : chain) parts.push_back({moments_[i], links_[i].material});
      if (parts.empty()) continue;
      mergeToTwo(parts);
      const double volume = grid.volume_mm3(v, level_);
      for (const Part& part : parts)
        fitted.push_back({fitDistribution(part.moments, volume, part.material), volume, block, bit});
    }
  }

  const std::vector<Component> components = encodeConserving(fitted);
  int last = -1;
  for (size_t i = 0; i < fitted.size(); ++i) {
    if (components[i].lengthDensity() == 0) continue;
    Brick::Block& block = result.grid[fitted[i].block];
    const uint64_t bit = uint64_t{1} << fitted[i].bit;
    if (fitted[i].block != last) block.first = static_cast<uint32_t>(result.components.size());
    last = fitted[i].block;
    (block.occupied & bit ? block.second : block.occupied) |= bit;
    result.components.push_back(components[i]);
  }
  result.components.shrink_to_fit();
  return result;
}

}  // namespace loomlight
