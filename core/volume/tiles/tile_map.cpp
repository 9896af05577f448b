#include "core/volume/tiles/tile_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/base/error.h"
#include "core/volume/tiles/shape_table.h"

// How it works. A cell's shape depends on the yarns and crossings around it, so it repeats with weave and colours; its
// phase depends on the twist, which repeats with another period. So the two are kept apart: one repeat of shapes, row
// by row, and for each yarn of the piece a row and the phase of its first cell. How thick an uneven yarn is there, and
// how far aside it lies, never repeats with either: its spool tells the kind of each stretch, one stretch a period.
// Rows are shared between copies of the map.
namespace loomlight {

TileMap::TileMap(const ClothGeometry& geometry, System system, std::shared_ptr<BrickPool> pool, const Task& task)
    : system_(system), bricks_(std::move(pool)) {
  findExtent(geometry);
  placeYarns(geometry);
  takeSpools(geometry);
  ShapeTable table(geometry, system);
  readRows(geometry, task, {}, table);
  countCells(task);
}

void TileMap::findExtent(const ClothGeometry& geometry) {
  const bool warp = system_ == System::warp;
  yarnCount_ = warp ? geometry.ends() : geometry.picks();
  cells_ = warp ? geometry.picks() : geometry.ends();
  repeatAcross_ = std::min(yarnCount_, warp ? geometry.repeatEnds() : geometry.repeatPicks());
  repeatAlong_ = std::min(cells_, warp ? geometry.repeatPicks() : geometry.repeatEnds());
  inRepeat_ = Modulo(static_cast<uint32_t>(repeatAlong_));
  if (static_cast<double>(repeatAcross_) * repeatAlong_ > kMaxCrossings)
    throw InputError(
        fmt::format("the cloth repeats only after {} ends and {} picks: expected at most {:.0f} crossings; "
                    "yarn sequences and spacings whose lengths divide that of the weave make the repeat shorter",
                    geometry.repeatEnds(), geometry.repeatPicks(), kMaxCrossings));
}

void TileMap::placeYarns(const ClothGeometry& geometry) {
  const std::shared_ptr<PlacedYarn[]> yarns(new PlacedYarn[static_cast<size_t>(yarnCount_)]);
  for (int across = 0; across < yarnCount_; ++across) {
    const int period = geometry.yarn(system_, geometry.geometryClass(system_, across)).period;
    const YarnTable::Place first =
        system_ == System::warp ? geometry.place(system_, 0, across) : geometry.place(system_, across, 0);
    assert(0 <= first.phase && first.phase < period && period <= kMaxPeriod);
    yarns[across] = {static_cast<uint32_t>(across % repeatAcross_), static_cast<uint16_t>(first.stretch),
                     static_cast<uint8_t>(first.phase), static_cast<uint8_t>(period)};
  }
  yarns_ = yarns;
}

/// Where there are other kinds of stretches than before, all bricks are missing.
void TileMap::takeSpools(const ClothGeometry& geometry) {
  spools_.clear();
  spoolOf_.clear();
  int kinds = 1;
  for (int row = 0; row < repeatAcross_; ++row) {
    const auto yarn = static_cast<size_t>(geometry.geometryClass(system_, row));
    spools_.resize(std::max(spools_.size(), yarn + 1));
    spools_[yarn] = geometry.yarns().spool(system_, static_cast<int>(yarn));
    spoolOf_.push_back(spools_[yarn].get());
    if (spools_[yarn]) kinds = std::max(kinds, spools_[yarn]->kinds());
  }
  if (kinds == 1) spoolOf_.clear();
  if (kinds == stretchKinds_) return;
  stretchKinds_ = kinds;
  bricks_ = BrickTable(bricks_.pool());
  bricks_.resize(index({static_cast<uint32_t>(shapes_.size())}));
}

double TileMap::cells(Kind kind) const {
  const auto cells = static_cast<double>(cellsOf_[phaseIndex(kind.shape, kind.phase)]);
  if (cells == 0) return 0;  // perhaps of a yarn that is no longer there
  const auto& spool = spools_[static_cast<size_t>(shapes_[kind.shape].yarn)];
  if (spool) return kind.stretch < spool->kinds() ? cells * spool->share(kind.stretch) : 0.0;
  return kind.stretch == 0 ? cells : 0.0;
}

YarnCellKey TileMap::key(Kind kind) const {
  YarnCellKey key = shapes_[kind.shape];
  key.phase = kind.phase;
  key.stretch = kind.stretch;
  return key;
}

std::vector<TileMap::Kind> TileMap::missing() const {
  std::vector<Kind> missing;
  forEachKind([&](Kind kind) {
    if (cells(kind) > 0 && !brick(kind)) missing.push_back(kind);
  });
  return missing;
}

std::vector<ClothGeometry::CellCount> TileMap::cellCounts() const {
  std::vector<ClothGeometry::CellCount> counts;
  for (uint32_t shape = 0; shape < shapes_.size(); ++shape) {
    const uint64_t* const cells = &cellsOf_[phaseIndex(shape, 0)];
    if (const uint64_t sum = std::accumulate(cells, cells + kMaxPeriod, uint64_t{0}); sum > 0)
      counts.push_back({shapes_[shape], static_cast<double>(sum)});
  }
  return counts;
}

void TileMap::shareRows(const TileMap& other) {
  std::vector<SharedList<Row>::Pointer> rows = rows_.all();
  for (size_t i = 0; i < std::min(rows.size(), other.rows_.size()); ++i) {
    if (*rows[i] != *other.rows_[i]) continue;
    rows[i] = other.rows_[i];
    pointTo(i, *rows[i]);
  }
  rows_ = SharedList<Row>(rows);
}

size_t TileMap::spoolBytes() const {
  size_t bytes = spoolOf_.size() * sizeof(const Spool*);
  for (const auto& spool : spools_) bytes += spool ? spool->bytes() : 0;
  return bytes;
}

size_t TileMap::bytesBeside(const TileMap& other) const {
  size_t bytes = shapes_.capacity() * sizeof(shapes_[0]) + codes_.capacity() * sizeof(codes_[0]) +
                 cellsOf_.capacity() * sizeof(cellsOf_[0]) + bricks_.bytesBeside(other.bricks_) + rows_.bytes() +
                 (low_.capacity() + high_.capacity()) * sizeof(low_[0]);
  if (spools_ != other.spools_) bytes += spoolBytes();
  if (yarns_ != other.yarns_) bytes += static_cast<size_t>(yarnCount_) * sizeof(PlacedYarn);
  rows_.forEachBeside(other.rows_, [&bytes](const auto& row) { bytes += row->bytes(); });
  return bytes;
}

size_t TileMap::bytes() const {
  size_t used = 0;
  for (uint32_t shape = 0; shape < shapes_.size(); ++shape) {
    const auto first = cellsOf_.begin() + static_cast<std::ptrdiff_t>(phaseIndex(shape, 0));
    used += std::any_of(first, first + kMaxPeriod, [](uint64_t cells) { return cells > 0; });
  }
  const size_t perShape = sizeof(YarnCellKey) + sizeof(codes_[0]) +
                          kMaxPeriod * (sizeof(uint64_t) + static_cast<size_t>(stretchKinds_) * sizeof(BrickPool::Id));
  const size_t perRow = sizeof(Row) + sizeof(rows_[0]) + sizeof(low_[0]) +
                        static_cast<size_t>(repeatAlong_) * (used > 0x10000 ? 2 : 1) * sizeof(uint16_t);
  return static_cast<size_t>(yarnCount_) * sizeof(PlacedYarn) + rows_.size() * perRow + used * perShape + spoolBytes();
}

}  // namespace loomlight
