#include "render/share/cell_sums.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

#include "render/film/fixed_point.h"

// How it works. A table of open addressing finds a cell by its key; each cell knows the coarser one that it lies in,
// and a deposit goes up from cell to cell. Sums are integers, so that threads may add in any order. The mean of a cell
// is a compromise between its own paths and the cell that it lies in, level by level from the coarsest: how much a
// parent counts is read off the sums by an analysis of variance, since cells that differ by no more than noise tell no
// more than their parent.
namespace loomlight {
namespace {

// 2^24 paths of the brightest light do not overflow.
constexpr double kQuantum = 0x1p-20, kMostColour = 0x1p18;
constexpr double kWrap = 0x1p64;  // quanta of squares

int64_t quantised(double value) {
  return std::isnan(value) ? 0 : std::llround(std::clamp(value, -kMostColour, kMostColour) / kQuantum);
}

/// How paths spread about the means of the cells of a level, and how these means spread about those of their parents:
/// sums of squares and their degrees of freedom.
struct LevelSpread {
  double within = 0, withinFreedom = 0;
  double between = 0, betweenFreedom = 0;
  double betweenPaths = 0;  ///< what a variance of one between cells would make of `between`
};
using LevelSpreads = std::array<LevelSpread, kLightCellLevels>;

/// One-way analysis of variance with unequal groups (Searle, Casella, McCulloch 1992, section 3.6).
LevelSpreads spreadOf(const CellSums& sums) {
  LevelSpreads levels;
  // Of the cells in each: how many have paths, sum of |sum|^2 / paths, of paths^2, of paths.
  struct Children {
    double count = 0, squares = 0, paths2 = 0, paths = 0;
  };
  std::vector<Children> children(sums.size());
  for (uint32_t i = 0; i < sums.size(); ++i) {
    const CellSums::Cell& cell = sums[i];
    if (cell.paths == 0) continue;
    const double paths = cell.paths, square = glm::dot(cell.sum(), cell.sum()) / paths;
    LevelSpread& level = levels[static_cast<size_t>(cell.level())];
    level.within += std::max(0.0, cell.sumOfSquares() - square);
    level.withinFreedom += paths - 1;
    if (cell.parent == i) continue;
    Children& of = children[cell.parent];
    of.count += 1;
    of.squares += square;
    of.paths2 += paths * paths;
    of.paths += paths;
  }
  for (uint32_t i = 0; i < sums.size(); ++i) {
    const Children& of = children[i];
    const CellSums::Cell& cell = sums[i];
    if (of.count < 2 || cell.level() + 1 >= kLightCellLevels) continue;
    // A faded cell may have fewer paths than its parts together.
    LevelSpread& level = levels[static_cast<size_t>(cell.level()) + 1];
    const double scale = of.paths / cell.paths;
    const glm::dvec3 sum = cell.sum();
    level.between += std::max(0.0, of.squares - scale * glm::dot(sum, sum) / cell.paths);
    level.betweenFreedom += of.count - 1;
    level.betweenPaths += of.paths - of.paths2 / of.paths;
  }
  return levels;
}

/// Of each level: with the variance s^2 within cells and t^2 between cells of one parent, a parent is worth s^2 / t^2
/// paths.
std::array<double, kLightCellLevels> parentWorths(const LevelSpreads& levels) {
  // At level 1 are yarns of all colours: what others show says nothing of one that is seen for the first time.
  constexpr double kLeast = 1, kMostOfAll = 1e6, kMostOfYarns = 4;
  std::array<double, kLightCellLevels> worths{};
  for (size_t l = 1; l < kLightCellLevels; ++l) {
    const LevelSpread& level = levels[l];
    const double most = l == 1 ? kMostOfYarns : kMostOfAll;
    worths[l] = most;
    if (level.withinFreedom < 1 || level.betweenFreedom < 1) continue;
    const double within = level.within / level.withinFreedom;
    const double between = (level.between - level.betweenFreedom * within) / level.betweenPaths;
    if (between > 0) worths[l] = std::clamp(within / between, kLeast, most);
  }
  return worths;
}

}  // namespace

glm::dvec3 CellSums::Cell::sum() const {
  return kQuantum *
         glm::dvec3(static_cast<double>(colour[0]), static_cast<double>(colour[1]), static_cast<double>(colour[2]));
}

double CellSums::Cell::sumOfSquares() const {
  return kSquareQuantum * (kWrap * wraps + static_cast<double>(squares));
}

CellSums::CellSums(size_t limit_bytes) {
  constexpr size_t kPerCell = sizeof(Cell) + sizeof(CellMeans::Mean);
  // There are always more slots than cells; with kLimit_bytes, more than twice as many.
  const size_t slots = std::bit_floor(std::max<size_t>(64, limit_bytes / 32));
  slots_.resize(slots);
  cells_.resize(
      std::max<size_t>(kLightCellLevels, (limit_bytes - std::min(limit_bytes, slots * sizeof(uint32_t))) / kPerCell));
  bytes_ = slots * sizeof(uint32_t) + cells_.size() * kPerCell;
}

size_t CellSums::roomFor(int level) const {
  constexpr size_t kParts = 10;  // each level has one less than the one before, the finest of five has six
  return cells_.size() - static_cast<size_t>(level) * cells_.size() / kParts;
}

/// Where the key is, or would be.
size_t CellSums::slotOf(uint64_t key) const {
  const size_t mask = slots_.size() - 1;
  size_t slot = mixBits(key) & mask;
  while (slots_[slot] != 0 && cells_[slots_[slot] - 1].key != key) slot = (slot + 1) & mask;
  return slot;
}

std::optional<uint32_t> CellSums::find(uint64_t key) const {
  const uint32_t found = slots_[slotOf(key)];
  return found == 0 ? std::nullopt : std::optional(found - 1);
}

std::optional<uint32_t> CellSums::find(const LightCellPath& path) const {
  return find(path.finest());
}

bool CellSums::knows(uint64_t key) const {
  const auto cell = find(key);
  return cell && cells_[*cell].paths > 0;
}

std::optional<uint32_t> CellSums::nearest(const LightCellPath& path) const {
  for (auto key = path.keys.rbegin(); key != path.keys.rend(); ++key)
    if (const auto cell = find(*key)) return cell;
  return std::nullopt;
}

std::optional<uint32_t> CellSums::make(uint64_t key, uint32_t parent) {
  const size_t slot = slotOf(key);
  if (slots_[slot] != 0) return slots_[slot] - 1;
  if (size_ >= roomFor(static_cast<int>(key & kLightCellLevelMask))) return std::nullopt;
  const auto cell = static_cast<uint32_t>(size_++);
  cells_[cell] = {key, {0, 0, 0}, 0, 0, 0, size_ == 1 ? cell : parent};
  slots_[slot] = cell + 1;
  return cell;
}

uint32_t CellSums::add(const LightCellPath& path) {
  if (const auto known = find(path)) return *known;
  uint32_t cell = 0;
  for (const uint64_t key : path.keys) {
    const auto next = make(key, cell);
    if (!next) break;
    cell = *next;
  }
  return cell;
}

void CellSums::deposit(uint32_t cell, Rgb colour) {
  int64_t quanta[3];
  double square = 0;
  for (int c = 0; c < 3; ++c) {
    quanta[c] = quantised(colour[c]);
    square += std::pow(kQuantum * static_cast<double>(quanta[c]), 2);
  }
  const uint64_t squares = fixedPositive(square, kMaxSquare, kSquareQuantum);
  for (;;) {
    Cell& sums = cells_[cell];
    for (int c = 0; c < 3; ++c) sums.colour[c] += quanta[c];
    sums.addSquares(squares);
    ++sums.paths;
    if (sums.parent == cell) break;
    cell = sums.parent;
  }
}

void CellSums::fade(uint32_t mostPaths) {
  if (size_ == 0) return;
  double finest = 0;
  for (size_t i = 0; i < size_; ++i) finest += cells_[i].level() == kLightCellLevels - 1 && cells_[i].paths > 0;
  const double share = mostPaths * std::max(1.0, finest) / std::max(1u, cells_[0].paths);
  if (share >= 1) return;
  for (size_t i = 0; i < size_; ++i) {
    Cell& sums = cells_[i];
    const auto paths = static_cast<uint32_t>(std::lround(share * sums.paths));
    // What is left of the light is that of so many paths.
    const double kept = sums.paths > 0 ? paths / static_cast<double>(sums.paths) : 0;
    for (int64_t& channel : sums.colour) channel = static_cast<int64_t>(kept * static_cast<double>(channel));
    const double squares = kept * sums.sumOfSquares() / kSquareQuantum;
    sums.wraps = static_cast<uint32_t>(squares / kWrap);
    sums.squares = static_cast<uint64_t>(squares - kWrap * sums.wraps);
    sums.paths = paths;
  }
}

void CellSums::keep(size_t most) {
  if (size_ <= most) return;
  std::vector<uint32_t> paths;
  paths.reserve(size_);
  for (size_t i = 0; i < size_; ++i) paths.push_back(cells_[i].paths);
  const auto tooMany = paths.begin() + static_cast<std::ptrdiff_t>(most);
  std::nth_element(paths.begin(), tooMany, paths.end(), std::greater<>());
  const uint32_t fewest = *tooMany;  // that is too few to stay
  std::ranges::fill(slots_, 0u);
  // A cell has no more paths than the one that it lies in, which stays, too, and comes before it.
  std::vector<uint32_t> numbers(size_);
  const size_t before = std::exchange(size_, 0);
  for (size_t i = 0; i < before; ++i) {
    const Cell cell = cells_[i];
    if (cell.paths <= fewest) continue;
    numbers[i] = static_cast<uint32_t>(size_);
    cells_[size_] = cell;
    cells_[size_].parent = numbers[cell.parent];
    slots_[slotOf(cell.key)] = static_cast<uint32_t>(++size_);
  }
}

CellMeans::CellMeans(const CellSums& sums) : means_(sums.size()), worth_(parentWorths(spreadOf(sums))) {
  for (uint32_t i = 0; i < sums.size(); ++i) {
    const CellSums::Cell& cell = sums[i];
    const double paths = cell.paths, prior = cell.parent == i ? 0 : worth_[static_cast<size_t>(cell.level())];
    if (paths + prior == 0) continue;
    const Mean parent = means_[cell.parent];
    Mean& mean = means_[i];
    mean.colour = Rgb((cell.sum() + prior * glm::dvec3(parent.colour)) / (paths + prior));
    mean.square = static_cast<float>((cell.sumOfSquares() + prior * parent.square) / (paths + prior));
  }
}

}  // namespace loomlight
