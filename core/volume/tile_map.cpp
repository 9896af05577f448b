#include "core/volume/tile_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/volume/shape_table.h"

namespace loomlight {
namespace {

/// How many numbers in [0, total) leave the remainder r when divided by `period`.
int64_t countOfRemainder(int64_t total, int64_t period, int64_t r) {
  return (total - r + period - 1) / period;
}

/// Calls f for each i in [0, count) with i = first mod period.
template <class F>
void forEachRemainder(int first, int period, int count, const F& f) {
  const int r = first % period;
  for (int i = r < 0 ? r + period : r; i < count; i += period) f(i);
}

/// The bricks of more would not fit into memory anyway.
void checkShapes(const ShapeTable& table) {
  constexpr size_t kMaxShapes = size_t{1} << 20;
  if (table.shapes().size() > kMaxShapes)
    throw InputError(
        fmt::format("the cloth has more than {} shapes of yarn cells: expected fewer different yarns or a smaller "
                    "repeat",
                    kMaxShapes));
}

}  // namespace

/// In which phases the cells of one yarn of the repeat occur in the piece, and how often.
class TileMap::PhaseCounts {
 public:
  PhaseCounts(const TileMap& map, int row)
      : map_(map),
        period_(map.yarns_[row].period),
        start_(map.yarns_[row].phase),
        once_(map.yarnCount_ == map.repeatAcross_ && map.cells_ == map.repeatAlong_) {
    if (once_) return;
    std::array<uint64_t, kMaxPeriod> starts{};  // yarns of the piece by the phase of their first cell
    for (int across = row; across < map.yarnCount_; across += map.repeatAcross_) ++starts[map.yarns_[across].phase];
    // Cells near the start of the repeat may occur once more than those near its end.
    for (const bool more : {false, true}) count(starts, map.cells_ / map.repeatAlong_ + more, turned_[more]);
  }
  /// Adds the cell at `along` to the counts of a shape by phase; or takes it away, `sign` being -1 (modulo 2^64).
  void add(int along, uint64_t* cellsOf, uint64_t sign = 1) const {
    if (once_) {
      cellsOf[(start_ + along) % period_] += sign;
      return;
    }
    const Turned& turned = turned_[along < map_.cells_ % map_.repeatAlong_];
    const auto& counts = turned[along % period_];
    for (int phase = 0; phase < kMaxPeriod; ++phase) cellsOf[phase] += sign * counts[phase];
  }

 private:
  using Turned = std::array<std::array<uint64_t, kMaxPeriod>, kMaxPeriod>;  ///< [along % period][phase]

  void count(const std::array<uint64_t, kMaxPeriod>& starts, int64_t repeats, Turned& turned) const {
    std::array<uint64_t, kMaxPeriod> counts{};
    for (int64_t i = 0; i < std::min<int64_t>(repeats, period_); ++i)
      for (int start = 0; start < period_; ++start)
        counts[(start + i * map_.repeatAlong_) % period_] += starts[start] * countOfRemainder(repeats, period_, i);
    for (int turn = 0; turn < period_; ++turn) {
      turned[turn].fill(0);
      for (int phase = 0; phase < period_; ++phase) turned[turn][(phase + turn) % period_] = counts[phase];
    }
  }

  const TileMap& map_;
  int period_, start_;
  bool once_;  ///< the piece is one repeat: each of its cells is there once
  std::array<Turned, 2> turned_;
};

TileMap::TileMap(const ClothGeometry& geometry, System system, const Task& task) : system_(system) {
  const bool warp = system == System::warp;
  yarnCount_ = warp ? geometry.ends() : geometry.picks();
  cells_ = warp ? geometry.picks() : geometry.ends();
  repeatAcross_ = std::min(yarnCount_, warp ? geometry.repeatEnds() : geometry.repeatPicks());
  repeatAlong_ = std::min(cells_, warp ? geometry.repeatPicks() : geometry.repeatEnds());
  if (static_cast<double>(repeatAcross_) * repeatAlong_ > kMaxCrossings)
    throw InputError(
        fmt::format("the cloth repeats only after {} ends and {} picks: expected at most {:.0f} crossings; "
                    "yarn sequences whose lengths divide that of the weave make the repeat shorter",
                    geometry.repeatEnds(), geometry.repeatPicks(), kMaxCrossings));
  placeYarns(geometry);
  readRows(geometry, task);
}

void TileMap::placeYarns(const ClothGeometry& geometry) {
  const std::shared_ptr<PlacedYarn[]> yarns(new PlacedYarn[static_cast<size_t>(yarnCount_)]);
  for (int across = 0; across < yarnCount_; ++across) {
    const int period = geometry.yarn(system_, geometry.geometryClass(system_, across)).period;
    const int phase = system_ == System::warp ? geometry.phase(system_, 0, across) : geometry.phase(system_, across, 0);
    assert(0 <= phase && phase < period && period <= kMaxPeriod);
    yarns[across] = {static_cast<uint32_t>(across % repeatAcross_), static_cast<uint16_t>(phase),
                     static_cast<uint16_t>(period)};
  }
  yarns_ = yarns;
}

/// Neighbouring yarns, read by one thread, with a numbering of its own.
struct TileMap::Band {
  int first, end;
  std::vector<std::shared_ptr<Row>> rows;
  std::vector<CellKey> shapes;
  std::vector<uint64_t> cellsOf;
};

void TileMap::readRows(const ClothGeometry& geometry, const Task& task) {
  constexpr int kBand = 32;         // yarns
  constexpr size_t kTogether = 16;  // bands: their tables must not pile up
  rows_.resize(static_cast<size_t>(repeatAcross_));
  low_.resize(rows_.size());
  ShapeTable all(geometry, system_);
  for (int first = 0; first < repeatAcross_;) {
    std::vector<Band> bands;
    for (; first < repeatAcross_ && bands.size() < kTogether; first += kBand)
      bands.push_back({first, std::min(first + kBand, repeatAcross_), {}, {}, {}});
    parallelFor(bands.size(), task.threads, [&](size_t band) { readBand(geometry, task, bands[band]); });
    if (task.stopped()) return;
    // In order, so that the numbers are the same for any number of threads.
    for (Band& band : bands) join(band, all);
  }
}

void TileMap::readBand(const ClothGeometry& geometry, const Task& task, Band& band) const {
  ShapeTable table(geometry, system_);
  std::vector<ClothGeometry::ShapeCode> codes(static_cast<size_t>(repeatAlong_));
  std::vector<uint32_t> shapes(codes.size());
  for (int across = band.first; across < band.end && !task.stopped(); ++across) {
    const PhaseCounts phases(*this, across);
    geometry.shapeCodes(system_, across, 0, codes);
    for (int along = 0; along < repeatAlong_; ++along) {
      const uint32_t shape = shapes[along] = table.number(codes[along]);
      if (band.cellsOf.size() <= index({shape, 0})) band.cellsOf.resize(2 * index({shape + 1, 0}));
      phases.add(along, &band.cellsOf[index({shape, 0})]);
    }
    band.rows.push_back(std::make_shared<Row>(shapes));
    checkShapes(table);
  }
  band.shapes = table.shapes();
}

void TileMap::join(Band& band, ShapeTable& all) {
  std::vector<uint32_t> numbers;
  for (const CellKey& shape : band.shapes) numbers.push_back(all.number(shape));
  addShapes(all);
  bool renumbered = false;
  for (uint32_t shape = 0; shape < numbers.size(); ++shape) {
    renumbered |= numbers[shape] != shape;
    for (int phase = 0; phase < kMaxPeriod; ++phase)
      cellsOf_[index({numbers[shape], phase})] += band.cellsOf[index({shape, phase})];
  }
  for (size_t i = 0; i < band.rows.size(); ++i) {
    Row& row = *band.rows[i];
    if (renumbered)
      for (size_t along = 0; along < row.low.size(); ++along) row.set(along, numbers[row.at(along)]);
    setRow(static_cast<size_t>(band.first) + i, band.rows[i]);
  }
}

TileMap::Row::Row(std::span<const uint32_t> shapes) : low(shapes.begin(), shapes.end()) {
  if (std::all_of(shapes.begin(), shapes.end(), [](uint32_t shape) { return shape >> 16 == 0; })) return;
  high.reserve(shapes.size());
  for (const uint32_t shape : shapes) high.push_back(static_cast<uint16_t>(shape >> 16));
}

void TileMap::Row::set(size_t i, uint32_t shape) {
  low[i] = static_cast<uint16_t>(shape);
  if (shape >> 16 != 0) high.resize(low.size());
  if (!high.empty()) high[i] = static_cast<uint16_t>(shape >> 16);
}

void TileMap::setRow(size_t number, std::shared_ptr<const Row> row) {
  low_[number] = row->low.data();
  if (!row->high.empty()) high_.resize(rows_.size());
  if (!high_.empty()) high_[number] = row->high.empty() ? nullptr : row->high.data();
  rows_[number] = std::move(row);
}

void TileMap::edit(const ClothGeometry& geometry, std::span<const WeavePlace> places) {
  const bool warp = system_ == System::warp;
  const int weaveAcross = warp ? geometry.weave().ends() : geometry.weave().picks();
  ShapeTable table(geometry, system_);
  for (const CellKey& shape : shapes_) table.number(shape);
  std::map<int, std::vector<int>> changed;  // yarn of the weave: where along it
  for (const WeavePlace& place : places)
    changed[warp ? place.end : place.pick].push_back(warp ? place.pick : place.end);
  for (const auto& yarn : changed)
    forEachRemainder(yarn.first, weaveAcross, repeatAcross_,
                     [&](int across) { editRow(geometry, across, yarn.second, table); });
  dropUnused();
}

void TileMap::editRow(const ClothGeometry& geometry, int across, std::span<const int> places, ShapeTable& table) {
  const int weaveAlong = system_ == System::warp ? geometry.weave().picks() : geometry.weave().ends();
  const PhaseCounts phases(*this, across);
  const auto row = std::make_shared<Row>(*rows_[across]);
  const auto read = [&](int along) {
    ClothGeometry::ShapeCode code;
    geometry.shapeCodes(system_, across, along, {&code, 1});
    const uint32_t before = row->at(static_cast<size_t>(along)), after = table.number(code);
    if (before == after) return;
    addShapes(table);
    phases.add(along, &cellsOf_[index({before, 0})], ~uint64_t{0});
    phases.add(along, &cellsOf_[index({after, 0})]);
    row->set(static_cast<size_t>(along), after);
  };
  for (const int place : places)
    for (int i = -ClothGeometry::kCrossingReach; i <= ClothGeometry::kCrossingReach; ++i)
      forEachRemainder(place + i, weaveAlong, repeatAlong_, read);
  setRow(static_cast<size_t>(across), row);
}

void TileMap::addShapes(const ShapeTable& table) {
  checkShapes(table);
  shapes_.insert(shapes_.end(), table.shapes().begin() + static_cast<std::ptrdiff_t>(shapes_.size()),
                 table.shapes().end());
  const size_t size = index({static_cast<uint32_t>(shapes_.size()), 0});
  cellsOf_.resize(size);
  bricks_.resize(size);
  slots_.resize(size);
}

void TileMap::dropUnused() {
  for (size_t i = 0; i < slots_.size(); ++i) {
    if (cellsOf_[i] > 0) continue;
    bricks_[i] = nullptr;
    slots_[i] = {};
  }
  findReaches();
}

CellKey TileMap::key(Kind kind) const {
  CellKey key = shapes_[kind.shape];
  key.phase = kind.phase;
  return key;
}

std::vector<TileMap::Kind> TileMap::missing() const {
  std::vector<Kind> missing;
  for (uint32_t shape = 0; shape < shapes_.size(); ++shape)
    for (int phase = 0; phase < kMaxPeriod; ++phase)
      if (const Kind kind{shape, phase}; cells(kind) > 0 && !brick(kind)) missing.push_back(kind);
  return missing;
}

std::vector<ClothGeometry::CellCount> TileMap::cellCounts() const {
  std::vector<ClothGeometry::CellCount> counts;
  for (uint32_t shape = 0; shape < shapes_.size(); ++shape) {
    const uint64_t* const cells = &cellsOf_[index({shape, 0})];
    if (const uint64_t sum = std::accumulate(cells, cells + kMaxPeriod, uint64_t{0}); sum > 0)
      counts.push_back({shapes_[shape], static_cast<double>(sum)});
  }
  return counts;
}

void TileMap::place(Kind kind, std::shared_ptr<const Brick> brick) {
  Slot& s = slots_[index(kind)];
  s = {brick.get(), false, false};
  const int axis = system_ == System::warp ? 0 : 1;
  for (int l = 0; l < brick->levels(); ++l) {
    const Brick::Level& level = brick->level(l);
    const int first = level.lower[axis], perCell = level.blocksPerCell()[axis];
    for (size_t i = 0; i < level.grid.size(); ++i) {
      if (!level.grid[i].occupied) continue;
      const auto block = static_cast<int>(i);
      const int b = first + (axis == 0 ? block % level.blocks.x : block / level.blocks.x % level.blocks.y);
      s.reachesBelow |= b < 0;
      s.reachesAbove |= b >= perCell;
    }
  }
  anyReachesBelow_ |= s.reachesBelow;
  anyReachesAbove_ |= s.reachesAbove;
  bricks_[index(kind)] = std::move(brick);
}

void TileMap::findReaches() {
  const auto any = [this](bool Slot::*reaches) {
    return std::any_of(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.*reaches; });
  };
  anyReachesBelow_ = any(&Slot::reachesBelow);
  anyReachesAbove_ = any(&Slot::reachesAbove);
}

void TileMap::shareRows(const TileMap& other) {
  for (size_t i = 0; i < std::min(rows_.size(), other.rows_.size()); ++i)
    if (*rows_[i] == *other.rows_[i]) setRow(i, other.rows_[i]);
}

size_t TileMap::bytesBeside(const TileMap& other) const {
  const auto sharedAt = [](const auto& mine, const auto& others, size_t i) {
    return i < others.size() && mine[i] == others[i];
  };
  size_t bytes = shapes_.capacity() * sizeof(shapes_[0]) + cellsOf_.capacity() * sizeof(cellsOf_[0]) +
                 bricks_.capacity() * sizeof(bricks_[0]) + slots_.capacity() * sizeof(slots_[0]) +
                 rows_.capacity() * sizeof(rows_[0]) + (low_.capacity() + high_.capacity()) * sizeof(low_[0]);
  if (yarns_ != other.yarns_) bytes += static_cast<size_t>(yarnCount_) * sizeof(PlacedYarn);
  for (size_t i = 0; i < rows_.size(); ++i)
    if (!sharedAt(rows_, other.rows_, i)) bytes += rows_[i]->bytes();
  for (size_t i = 0; i < bricks_.size(); ++i)
    if (bricks_[i] && !sharedAt(bricks_, other.bricks_, i)) bytes += bricks_[i]->bytes();
  return bytes;
}

size_t TileMap::bytes() const {
  size_t used = 0;
  for (uint32_t shape = 0; shape < shapes_.size(); ++shape) {
    const auto first = cellsOf_.begin() + static_cast<std::ptrdiff_t>(index({shape, 0}));
    used += std::any_of(first, first + kMaxPeriod, [](uint64_t cells) { return cells > 0; });
  }
  const size_t perShape = sizeof(CellKey) + kMaxPeriod * (sizeof(uint64_t) + sizeof(bricks_[0]) + sizeof(Slot));
  const size_t perRow = sizeof(Row) + sizeof(rows_[0]) + sizeof(low_[0]) +
                        static_cast<size_t>(repeatAlong_) * (used > 0x10000 ? 2 : 1) * sizeof(uint16_t);
  return static_cast<size_t>(yarnCount_) * sizeof(PlacedYarn) + rows_.size() * perRow + used * perShape;
}

}  // namespace loomlight
