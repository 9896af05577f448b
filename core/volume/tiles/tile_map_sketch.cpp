#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

#include "core/volume/tiles/tile_map.h"

// How it works. The missing bricks are ordered by what a picture needs first: of each shape in view one brick, in any
// phase; then the other phases in view; then all the rest. As soon as the first are there the map can be shown:
// whatever is still missing takes the brick of its own shape in another phase, or of the shape of its yarn whose
// path is most alike.
namespace loomlight {
namespace {

/// How unlike two paths through a cell are, mm.
float unlikeness(const YarnCellKey& a, const YarnCellKey& b) {
  const auto apart = [](const PathNode& p, const PathNode& q) {
    return std::abs(p.height_mm - q.height_mm) + std::abs(p.aside_mm - q.aside_mm) + std::abs(p.along_mm - q.along_mm);
  };
  return apart(a.previous, b.previous) + 2 * apart(a.here, b.here) + apart(a.next, b.next);
}

}  // namespace

/// By index(). Too many crossings to go through are all there are.
std::vector<bool> TileMap::kindsIn(const CellRect& rect) const {
  constexpr double kMost = 1 << 20;
  std::vector<bool> kinds(bricks_.size(), static_cast<double>(rect.ends) * rect.picks > kMost);
  if (kinds.empty() || kinds.front()) return kinds;
  const bool warp = system_ == System::warp;
  const int across = warp ? rect.end : rect.pick, along = warp ? rect.pick : rect.end;
  const int acrossEnd = std::min(yarnCount_, across + (warp ? rect.ends : rect.picks));
  const int alongEnd = std::min(cells_, along + (warp ? rect.picks : rect.ends));
  for (int i = std::max(0, across); i < acrossEnd; ++i)
    for (int j = std::max(0, along); j < alongEnd; ++j) kinds[indexAt(i, j)] = true;
  return kinds;
}

bool TileMap::hasBrick(uint32_t shape) const {
  const size_t first = index({shape}), end = index({shape + 1});
  for (size_t kind = first; kind < end; ++kind)
    if (bricks_[kind]) return true;
  return false;
}

TileMap::Wanted TileMap::missing(const CellRect& inView) const {
  const std::vector<Kind> kinds = missing();
  if (kinds.empty()) return {};
  const std::vector<bool> seen = kindsIn(inView);
  std::vector<Kind> first, others, rest;
  std::set<int> yarns;  // that have bricks already, or will
  for (uint32_t shape = 0; shape < shapes_.size(); ++shape)
    if (hasBrick(shape)) yarns.insert(shapes_[shape].yarn);
  std::vector<bool> begun(shapes_.size());
  for (const Kind kind : kinds) {
    if (!seen[index(kind)]) {
      rest.push_back(kind);
    } else if (begun[kind.shape] || hasBrick(kind.shape)) {
      others.push_back(kind);
    } else {
      begun[kind.shape] = true;
      yarns.insert(shapes_[kind.shape].yarn);
      first.push_back(kind);
    }
  }
  // A yarn that is not seen has one brick too.
  const auto kept = std::stable_partition(rest.begin(), rest.end(),
                                          [&](Kind kind) { return yarns.insert(shapes_[kind.shape].yarn).second; });
  Wanted wanted;
  wanted.kinds = std::move(first);
  wanted.kinds.insert(wanted.kinds.end(), rest.begin(), kept);
  wanted.sketch = wanted.kinds.size();
  wanted.kinds.insert(wanted.kinds.end(), others.begin(), others.end());
  wanted.seen = wanted.kinds.size();
  wanted.kinds.insert(wanted.kinds.end(), kept, rest.end());
  return wanted;
}

void TileMap::standIn() {
  constexpr size_t kMostCompared = 64;  // of a yarn: of thousands there is hardly one that is much more alike
  std::unordered_map<int, std::vector<uint32_t>> known;  // shapes that have a brick, by their yarn
  uint32_t any = 0;
  for (uint32_t shape = 0; shape < shapes_.size(); ++shape) {
    if (!hasBrick(shape)) continue;
    any = shape;
    std::vector<uint32_t>& ofYarn = known[shapes_[shape].yarn];
    if (ofYarn.size() < kMostCompared) ofYarn.push_back(shape);
  }
  if (known.empty()) return;
  const auto likest = [&](uint32_t shape) {
    if (hasBrick(shape)) return shape;
    const YarnCellKey& key = shapes_[shape];
    const auto ofYarn = known.find(key.yarn);
    if (ofYarn == known.end()) return any;
    return *std::min_element(ofYarn->second.begin(), ofYarn->second.end(), [&](uint32_t x, uint32_t y) {
      return unlikeness(key, shapes_[x]) < unlikeness(key, shapes_[y]);
    });
  };
  const std::vector<Kind> kinds = missing();
  uint32_t by = 0;  // the shape that stands in
  for (size_t i = 0; i < kinds.size(); ++i) {
    const Kind kind = kinds[i];
    if (i == 0 || kind.shape != kinds[i - 1].shape) by = likest(kind.shape);
    // From its own phase and stretch on, the next that has one.
    const size_t first = index({by}), count = index({by + 1}) - first;
    size_t at = index(kind) - index({kind.shape});
    while (!bricks_[first + at]) at = (at + 1) % count;
    place(kind, bricks_[first + at]);
  }
}

}  // namespace loomlight
