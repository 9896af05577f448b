#include "core/volume/build/moment_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// How it works. Voxels lie in blocks of 4 x 4 x 4, and a voxel is a number: its block's, times 64, plus its own. Most
// voxels are empty and most of the others have fibres of one ply, so each voxel has the head of a linked list of
// moments, one for each ply; -1 where there is none. A coarser level adds the lists of eight voxels into one. fit()
// turns a voxel's list into components: where there are more than two plies, the pair whose merging loses least is
// merged until two are left. Voxels are encoded in order of their number, so that the components of a block lie
// together.
//
// A component's box ends where its fibres do; where the next voxel holds enough of the same ply, which is no rim then,
// it goes on to the face. What is known are bounds of lines inside the fibres (LeafFiller), which of few fibres fall
// short of the room that they take. So the box is wider than its bounds b, as if the variance of a fibre's section,
// r^2 / 4 across, came to that of an even density, b^2 / 12: w^2 = b^2 + 3 r^2. Of many fibres that is hardly anything.
// Without it gaps open between fibres that lie side by side, and sheer silk is 7 % too dark under a dome; with r on
// each side, rims of yarns are smeared as they are without boxes, and light that has no way comes through.

namespace loomlight {
namespace {

/// Where the next voxel holds more than this share of what a voxel does, the yarn goes on there: no rim lies between.
constexpr double kRim = 0.25;

int floorDivide(int a, int b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// The cell that a block (or voxel) lies in, -1, 0 or 1 across, and its place there.
struct BlockPosition {
  glm::ivec3 cell, inCell;
};
BlockPosition positionOf(glm::ivec3 block, glm::ivec3 perCell) {
  const glm::ivec3 cell(floorDivide(block.x, perCell.x), floorDivide(block.y, perCell.y), 0);
  return {cell, block - cell * perCell};
}

/// The block of a leaf voxel.
glm::ivec3 blockOf(glm::ivec3 voxel, glm::ivec3 perCell) {
  const BlockPosition position = positionOf(voxel, perCell);
  return position.cell * ((perCell + 3) >> 2) + (position.inCell >> 2);
}

glm::ivec3 blocksPerCell(const VoxelGrid& grid) {
  return (grid.perCell() + 3) >> 2;
}

/// Of a voxel's number in its block, that of the coarser voxel it lies in, from the first voxel of its block on.
constexpr std::array<uint8_t, 64> makeHalved() {
  std::array<uint8_t, 64> halved{};
  for (int i = 0; i < 64; ++i) halved[i] = static_cast<uint8_t>((i & 3) >> 1 | (i >> 2 & 3) >> 1 << 2 | i >> 5 << 4);
  return halved;
}
constexpr auto kHalved = makeHalved();

/// The moments of one ply in a voxel, or of several that had to be merged.
struct PlyMoments {
  FibreMoments moments;
  VoxelBox box;
  uint8_t ply;
};

/// Merges the most alike until two are left.
void mergeToTwo(std::vector<PlyMoments>& plies) {
  while (plies.size() > 2) {
    size_t first = 0, second = 1;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < plies.size(); ++i) {
      for (size_t j = i + 1; j < plies.size(); ++j) {
        const double cost = mergeCost(plies[i].moments, plies[j].moments);
        if (cost < least) {
          least = cost;
          first = i;
          second = j;
        }
      }
    }
    plies[first].moments.add(plies[second].moments);
    plies[first].box = around(plies[first].box, plies[second].box);
    plies.erase(plies.begin() + static_cast<std::ptrdiff_t>(second));
  }
}

/// Takes out the components without length density.
void dropEmpty(Brick& brick) {
  const auto empty = [](Component c) { return c.lengthDensity() == 0; };
  if (std::none_of(brick.components.begin(), brick.components.end(), empty)) return;
  std::vector<Component> kept;
  for (BrickBlock& block : brick.blocks) {
    const BrickBlock before = std::exchange(block, {});
    block.first = static_cast<uint32_t>(kept.size());
    for (uint64_t rest = before.occupied; rest != 0; rest &= rest - 1) {
      const uint64_t bit = rest & -rest;
      for (const Component c : before.at(std::countr_zero(rest), brick.components.data())) {
        if (empty(c)) continue;
        (block.occupied & bit ? block.second : block.occupied) |= bit;
        kept.push_back(c);
      }
    }
    if (block.occupied == 0) block.first = 0;
  }
  brick.components = std::move(kept);
}

}  // namespace

void MomentLevel::resetBlocks(const VoxelGrid& grid, glm::ivec3 lower, glm::ivec3 blocks) {
  for (std::vector<int32_t>& offsets : offsets_) offsets.clear();
  grid_ = grid;
  perCell_ = blocksPerCell(grid);
  lower_ = lower;
  blocks_ = blocks;
  occupied_.assign(static_cast<size_t>(blocks.x) * blocks.y * blocks.z, 0);
  heads_.assign(64 * occupied_.size(), -1);
  links_.clear();
  moments_.clear();
  bounds_.clear();
}

void MomentLevel::reset(const VoxelGrid& leaves, glm::ivec3 first, glm::ivec3 last, glm::ivec3 origin,
                        float fibreRadius_mm) {
  origin_ = origin;
  const glm::ivec3 lower = blockOf(first, leaves.cell);
  resetBlocks(leaves, lower, blockOf(last, leaves.cell) + 1 - lower);
  first_ = first - origin;
  for (int axis = 0; axis < 3; ++axis)
    for (int v = origin[axis]; v <= last[axis]; ++v) offsets_[axis].push_back(offset(axis, v));
  fibreRadius_ = fibreRadius_mm / leaves.size_mm;
}

int32_t MomentLevel::offset(int axis, int v) const {
  const int cell = grid_.perCell()[axis], inCell = v - floorDivide(v, cell) * cell;
  const int block = floorDivide(v, cell) * perCell_[axis] + (inCell >> 2) - lower_[axis];
  const int stride[] = {1, blocks_.x, blocks_.x * blocks_.y};
  return 64 * block * stride[axis] + ((inCell & 3) << (2 * axis));
}

glm::ivec3 MomentLevel::blockAt(size_t number) const {
  const int n = static_cast<int>(number);
  return lower_ + glm::ivec3(n % blocks_.x, n / blocks_.x % blocks_.y, n / (blocks_.x * blocks_.y));
}

MomentLevel::Fibres MomentLevel::append(int32_t voxel, uint8_t ply) {
  links_.push_back({heads_[voxel], ply});
  heads_[voxel] = static_cast<int32_t>(moments_.size());
  occupied_[voxel >> 6] |= uint64_t{1} << (voxel & 63);
  return {moments_.emplace_back(), bounds_.emplace_back()};
}

void MomentLevel::resetToCoarser(const MomentLevel& finer) {
  const VoxelGrid grid = finer.grid_.atLevel(finer.grid_.level + 1);
  const glm::ivec3 parentsPerCell = blocksPerCell(grid);
  const auto parentOf = [&](glm::ivec3 block) {
    const BlockPosition position = positionOf(block, finer.perCell_);
    return position.cell * parentsPerCell + (position.inCell >> 1);
  };
  const glm::ivec3 lower = parentOf(finer.lower_), last = parentOf(finer.lower_ + finer.blocks_ - 1);
  resetBlocks(grid, lower, finer.occupied_.empty() ? glm::ivec3(0) : last + 1 - lower);
  for (size_t number = 0; number < finer.occupied_.size(); ++number) {
    if (finer.occupied_[number] == 0) continue;
    // The block is an octant of its parent.
    const glm::ivec3 block = finer.blockAt(number), p = parentOf(block) - lower;
    const glm::ivec3 octant = positionOf(block, finer.perCell_).inCell & 1;
    const int parent = (p.z * blocks_.y + p.y) * blocks_.x + p.x;
    const int first = 64 * parent + 2 * (octant.x + 4 * octant.y + 16 * octant.z);
    for (uint64_t rest = finer.occupied_[number]; rest != 0; rest &= rest - 1) {
      const int voxel = std::countr_zero(rest);
      for (int32_t i = finer.heads_[64 * number + voxel]; i >= 0; i = finer.links_[i].next)
        at(first + kHalved[voxel], finer.links_[i].ply).moments.add(finer.moments_[i]);
    }
  }
}

inline double MomentLevel::lengthBeside_mm(const Place& place, int axis, int v, int step, uint8_t ply) const {
  const std::span<const int32_t> offsets = offsets_[axis];
  if (v + step < first_[axis] || v + step >= static_cast<int>(offsets.size())) return 0;
  int32_t i = heads_[place.number + offsets[v + step] - offsets[v]];
  while (i >= 0 && links_[i].ply != ply) i = links_[i].next;
  return i >= 0 ? moments_[i].length_mm() : 0;
}

VoxelBox MomentLevel::boxOf(size_t fibres, const Place& place) const {
  if (grid_.level > 0) return {};
  const glm::ivec3 voxel = place.voxel - origin_;
  const glm::vec3 corner(voxel);
  const Float32x4 from{corner.x, corner.y, corner.z, 0};
  Float32x4 lower = bounds_[fibres].lower - from, upper = bounds_[fibres].upper - from;
  const uint8_t ply = links_[fibres].ply;
  const double most = kRim * moments_[fibres].length_mm();
  // Whether it ends short of a face, and whether it goes on beyond; every neighbour is looked at, as what is short is
  // what a processor cannot predict.
  Int32x4 before{}, beyond{};
  for (int axis = 0; axis < 3; ++axis) {
    before[axis] = -static_cast<int>(lengthBeside_mm(place, axis, voxel[axis], -1, ply) > most);
    beyond[axis] = -static_cast<int>(lengthBeside_mm(place, axis, voxel[axis], 1, ply) > most);
  }
  lower = (before & (lower > 0)) ? Float32x4{} : lower;
  upper = (beyond & (upper < 1)) ? Float32x4{} + 1 : upper;
  const Float32x4 radius{fibreRadius_.x, fibreRadius_.y, fibreRadius_.z, 0}, bounds = upper - lower;
  const Float32x4 wider = 0.5f * (squareRoot(bounds * bounds + 3 * radius * radius) - bounds);
  return VoxelBox::nearest(lower - wider, upper + wider);
}

int MomentLevel::encodeMany(const Place& place, ComponentEncoder& encoder) const {
  std::vector<PlyMoments> plies;
  for (int32_t i = heads_[place.number]; i >= 0; i = links_[i].next)
    if (moments_[i].length_mm() > 0)
      plies.push_back({moments_[i], boxOf(static_cast<size_t>(i), place), links_[i].ply});
  std::sort(plies.begin(), plies.end(), [](const PlyMoments& a, const PlyMoments& b) { return a.ply < b.ply; });
  mergeToTwo(plies);
  for (const PlyMoments& ply : plies) encoder.add(ply.moments, place.volume_mm3, ply.box);
  return static_cast<int>(plies.size());
}

inline int MomentLevel::encode(const Place& place, ComponentEncoder& encoder) const {
  const int32_t head = heads_[place.number];
  if (links_[head].next >= 0) return encodeMany(place, encoder);
  if (!(moments_[head].length_mm() > 0)) return 0;
  encoder.add(moments_[head], place.volume_mm3, boxOf(static_cast<size_t>(head), place));
  return 1;
}

Brick MomentLevel::fit(ComponentEncoder& encoder, size_t segments) const {
  Brick result;
  result.segments = segments;
  result.cell = grid_.perCell();
  result.box = {lower_, blocks_};
  result.blocks.resize(occupied_.size());
  for (size_t number = 0; number < occupied_.size(); ++number) {
    if (occupied_[number] == 0) continue;
    BrickBlock& block = result.blocks[number];
    block.first = static_cast<uint32_t>(encoder.count());
    const BlockPosition position = positionOf(blockAt(number), perCell_);
    const glm::ivec3 corner = 4 * position.inCell, first = position.cell * result.cell + corner;
    std::array<std::array<double, 4>, 3> extents_mm;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 4; ++i) extents_mm[axis][i] = grid_.extent_mm(axis, corner[axis] + i);
    for (uint64_t rest = occupied_[number]; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      const double volume = extents_mm[0][bit & 3] * extents_mm[1][bit >> 2 & 3] * extents_mm[2][bit >> 4];
      const glm::ivec3 voxel = first + glm::ivec3(bit & 3, bit >> 2 & 3, bit >> 4);
      const Place place{static_cast<int32_t>(64 * number) + bit, voxel, volume};
      const int plies = encode(place, encoder);
      block.occupied |= static_cast<uint64_t>(plies > 0) << bit;
      block.second |= static_cast<uint64_t>(plies > 1) << bit;
    }
  }
  result.components = encoder.take();
  dropEmpty(result);
  return result;
}

}  // namespace loomlight
