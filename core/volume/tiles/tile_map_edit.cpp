#include <algorithm>
#include <map>

#include "core/volume/tiles/phase_counts.h"
#include "core/volume/tiles/shape_table.h"
#include "core/volume/tiles/tile_map.h"

// How the TileMap of an edited cloth is made from the one before.
// How it works. A crossing shapes the cells of its two yarns within kCrossingReach of it, and where threads crowd those
// of the yarns beside. So the edited map copies the rows of these yarns, reads their cells again where they are in
// reach, and shares all other rows with the map before. The counts of cells of each kind are corrected cell by cell.
// Where the repeat changes its size, what old and new repeat have in common is copied (keptOf) and the rest is read;
// where yarns change their period, or the piece its size, all cells are counted again.

namespace loomlight {
namespace {

constexpr int kReach = kCrossingReach;

/// Of a weave, as one system sees it: how many yarns, and how many crossings along each.
struct WeaveSides {
  int across, along;
  bool operator==(const WeaveSides&) const = default;
  WeaveSides(const Weave& weave, System system)
      : across(system == System::warp ? weave.ends() : weave.picks()),
        along(system == System::warp ? weave.picks() : weave.ends()) {}
};

struct CellSpan {
  int from, to;  ///< [from, to)
};

/// Which crossings along a yarn are within reach of changed ones, of which the yarn has `count`; `places` in order.
std::vector<CellSpan> reachedFrom(std::span<const int> places, int count) {
  std::vector<CellSpan> spans;
  const auto add = [&](int from, int to) {
    if (from >= to) return;
    if (!spans.empty() && from <= spans.back().to) {
      spans.back().to = std::max(spans.back().to, to);
    } else {
      spans.push_back({from, to});
    }
  };
  // Round the ends of the repeat.
  add(0, std::min(count, places.back() + kReach + 1 - count));
  for (const int place : places) add(std::max(0, place - kReach), std::min(count, place + kReach + 1));
  add(std::max(0, count + places.front() - kReach), count);
  return spans;
}

}  // namespace

void TileMap::edit(const ClothGeometry& geometry, const Change& change, const Task& task) {
  for (ShapeCode& code : codes_) code = renamed(system_, code, change.names);
  if (!change.inWeaveAlone)
    for (size_t i = 0; i < shapes_.size(); ++i) shapes_[i] = geometry.shapeKey(system_, codes_[i]);
  ShapeTable table(geometry, system_, shapes_, codes_);
  const bool sameCells = !reshape(geometry, change, task, table);
  if (task.stopped()) return;

  const bool warp = system_ == System::warp;
  const int yarns = WeaveSides(geometry.weave(), system_).across, beside = geometry.codes().crowded() ? 1 : 0;
  std::map<int, std::vector<int>> changed;  // yarn of the weave: where along it
  for (const WeaveCrossing& place : change.places)
    for (int by = -beside; by <= beside; ++by)
      changed[wrap((warp ? place.end : place.pick) + by, yarns)].push_back(warp ? place.pick : place.end);
  for (auto& [yarn, places] : changed) {
    std::sort(places.begin(), places.end());
    for (int across = yarn; across < repeatAcross_; across += yarns)
      editRow(geometry, across, places, sameCells, table);
  }
  if (!sameCells) countCells(task);
  bricks_.keepOnly(cellsOf_, static_cast<size_t>(stretchKinds_));
}

/// Makes it the map of the geometry but for the changes of the weave. False where all cells lie as they did, each in
/// its phase: then their counts hold.
bool TileMap::reshape(const ClothGeometry& geometry, const Change& change, const Task& task, ShapeTable& table) {
  const int yarnCount = yarnCount_, cells = cells_, across = repeatAcross_, along = repeatAlong_;
  findExtent(geometry);
  const bool sameRepeat = across == repeatAcross_ && along == repeatAlong_ &&
                          WeaveSides(geometry.weave(), system_) == WeaveSides(change.before.weave(), system_);
  if (sameRepeat && change.inWeaveAlone) return false;
  readRows(geometry, task, keptOf(geometry, change.before, across, along), table);

  const auto yarns = yarns_;
  placeYarns(geometry);
  takeSpools(geometry);
  if (!sameRepeat || yarnCount != yarnCount_ || cells != cells_ ||
      !std::equal(yarns.get(), yarns.get() + yarnCount, yarns_.get()))
    return true;
  yarns_ = yarns;
  return false;
}

TileMap::Kept TileMap::keptOf(const ClothGeometry& geometry, const ClothGeometry& before, int formerAcross,
                              int formerAlong) const {
  const WeaveSides now(geometry.weave(), system_), then(before.weave(), system_);
  Kept kept;
  kept.yarns = std::min(repeatAcross_, formerAcross);
  if (now.across != then.across) {
    if (geometry.codes().crowded()) return {};  // the outermost have other neighbours
    kept.yarns = std::min({kept.yarns, now.across, then.across});
  }
  kept.to = std::min(repeatAlong_, formerAlong);
  if (now.along != then.along) {
    kept.from = kReach;
    kept.to = std::min({kept.to, now.along, then.along}) - kReach;
    if (kept.from >= kept.to) return {};
  } else {
    kept.wholeRows = repeatAlong_ == formerAlong;
  }
  return kept;
}

void TileMap::editRow(const ClothGeometry& geometry, int across, std::span<const int> places, bool counting,
                      ShapeTable& table) {
  const int weaveAlong = WeaveSides(geometry.weave(), system_).along;
  const PhaseCounts phases(*this, across);
  const auto row = std::make_shared<Row>(*rows_[across]);
  std::vector<ShapeCode> codes;
  const auto read = [&](int from, int to) {
    codes.resize(static_cast<size_t>(to - from));
    geometry.codes().read(system_, across, from, codes);
    for (int along = from; along < to; ++along) {
      const uint32_t before = row->at(static_cast<size_t>(along)), after = table.number(codes[along - from]);
      if (before == after) continue;
      row->set(static_cast<size_t>(along), after);
      if (!counting) continue;
      addShapes(table);
      phases.add(along, &cellsOf_[phaseIndex(before, 0)], ~uint64_t{0});
      phases.add(along, &cellsOf_[phaseIndex(after, 0)]);
    }
  };
  const std::vector<CellSpan> spans = reachedFrom(places, weaveAlong);
  for (int repeat = 0; repeat < repeatAlong_; repeat += weaveAlong)
    for (const CellSpan& span : spans)
      if (repeat + span.from < repeatAlong_) read(repeat + span.from, std::min(repeat + span.to, repeatAlong_));
  addShapes(table);
  rows_.set(static_cast<size_t>(across), row);
  pointTo(static_cast<size_t>(across), *row);
}

bool TileMap::isWorn() const {
  constexpr size_t kFew = 1024;
  return shapes_.size() > kFew && shapes_.size() > 2 * cellCounts().size();
}

}  // namespace loomlight
