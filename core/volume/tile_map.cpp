#include "core/volume/tile_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace loomlight {
namespace {

struct KeyHash {
  size_t operator()(const CellKey& key) const { return hash(key); }
};
/// Classes in the order in which they were met.
struct KeyTable {
  std::vector<CellKey> keys;
  std::unordered_map<CellKey, uint32_t, KeyHash> index;

  uint32_t operator()(const CellKey& key) {
    const auto [found, isNew] = index.try_emplace(key, static_cast<uint32_t>(keys.size()));
    if (isNew) keys.push_back(key);
    return found->second;
  }
};

CellKey keyAt(const ClothGeometry& geometry, System system, int across, int along) {
  return system == System::warp ? geometry.key(system, along, across) : geometry.key(system, across, along);
}

/// How many numbers in [0, total) leave the remainder r when divided by `period`.
int64_t countOfRemainder(int64_t total, int64_t period, int64_t r) {
  return (total - r + period - 1) / period;
}

}  // namespace

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
  const std::vector<CellKey> keys = readClasses(geometry, task);
  if (task.stopped()) return;
  placeYarns(geometry, keys);
  findNeeds(geometry, keys);
}

std::vector<CellKey> TileMap::readClasses(const ClothGeometry& geometry, const Task& task) {
  // Bands of yarns on many threads, each with its own numbering; joined in order, so that the result is the same for
  // any number of threads.
  constexpr int kBand = 64;
  const int bands = (repeatAcross_ + kBand - 1) / kBand;
  const auto along = static_cast<size_t>(repeatAlong_);
  std::vector<KeyTable> tables(bands);
  std::vector<std::vector<uint32_t>> numbers(bands);
  parallelFor(bands, task.threads, [&](size_t band) {
    const int first = static_cast<int>(band) * kBand, last = std::min(first + kBand, repeatAcross_);
    numbers[band].reserve((last - first) * along);
    for (int across = first; across < last && !task.stopped(); ++across)
      for (int i = 0; i < repeatAlong_; ++i) {
        CellKey key = keyAt(geometry, system_, across, i);
        key.phase = 0;
        numbers[band].push_back(tables[band](key));
      }
  });
  if (task.stopped()) return {};

  KeyTable all;
  std::vector<std::vector<uint32_t>> global(bands);
  for (int band = 0; band < bands; ++band)
    for (const CellKey& key : tables[band].keys) global[band].push_back(all(key));
  const size_t crossings = static_cast<size_t>(repeatAcross_) * along;
  lowBits_.resize(crossings);
  if (all.keys.size() > 0x10000) highBits_.resize(crossings);
  parallelFor(bands, task.threads, [&](size_t band) {
    size_t i = band * kBand * along;
    for (const uint32_t number : numbers[band]) {
      const uint32_t index = global[band][number];
      lowBits_[i] = static_cast<uint16_t>(index);
      if (!highBits_.empty()) highBits_[i] = static_cast<uint16_t>(index >> 16);
      ++i;
    }
  });
  return std::move(all.keys);
}

void TileMap::placeYarns(const ClothGeometry& geometry, const std::vector<CellKey>& keys) {
  size_t slots = 0;
  for (const CellKey& key : keys) {
    firstSlots_.push_back(static_cast<uint32_t>(slots));
    slots += static_cast<size_t>(geometry.yarn(system_, key.yarn).period);
    if (slots > UINT32_MAX)
      throw InputError(
          fmt::format("the cloth has {} shapes of yarn cells, each in all phases of its twist: expected "
                      "fewer than 2^32 together",
                      keys.size()));
  }
  slots_.resize(slots);
  yarns_.resize(yarnCount_);
  for (int across = 0; across < yarnCount_; ++across) {
    const auto row = static_cast<uint32_t>(across % repeatAcross_) * static_cast<uint32_t>(repeatAlong_);
    const int period = geometry.yarn(system_, keys[classAt(row)].yarn).period;
    const int phase = system_ == System::warp ? geometry.phase(system_, 0, across) : geometry.phase(system_, across, 0);
    assert(0 <= phase && phase < period && period <= UINT16_MAX);
    yarns_[across] = {row, static_cast<uint16_t>(phase), static_cast<uint16_t>(period)};
  }
}

void TileMap::findNeeds(const ClothGeometry& geometry, const std::vector<CellKey>& keys) {
  // Every phase that a class has in the piece. Once all phases of a class are found its crossings cost nothing more, so
  // the whole is about one visit per crossing of the repeat.
  std::vector<uint8_t> found(slots_.size(), 0);
  std::vector<uint32_t> foundOf(keys.size(), 0);
  std::vector<double> cellsOf(keys.size(), 0);
  std::vector<uint32_t> starts;
  for (int residue = 0; residue < repeatAcross_; ++residue) {
    starts.clear();
    for (int across = residue; across < yarnCount_; across += repeatAcross_) starts.push_back(yarns_[across].phase);
    const auto yarns = static_cast<double>(starts.size());
    const PlacedYarn& yarn = yarns_[residue];
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
    for (int along = 0; along < repeatAlong_; ++along) {
      const uint32_t c = classAt(yarn.row + static_cast<uint32_t>(along));
      const int64_t repeats = countOfRemainder(cells_, repeatAlong_, along);
      cellsOf[c] += yarns * static_cast<double>(repeats);
      if (foundOf[c] == yarn.period) continue;
      const int64_t distinct = std::min<int64_t>(repeats, yarn.period);  // then the phases begin anew
      for (const uint32_t start : starts) {
        for (int64_t i = 0; i < distinct; ++i) {
          uint8_t& flag = found[firstSlots_[c] + (start + along + i * repeatAlong_) % yarn.period];
          foundOf[c] += flag == 0;
          flag = 1;
        }
      }
    }
  }
  for (size_t c = 0; c < keys.size(); ++c) {
    const int period = geometry.yarn(system_, keys[c].yarn).period;
    for (int phase = 0; phase < period; ++phase) {
      const uint32_t slot = firstSlots_[c] + static_cast<uint32_t>(phase);
      if (!found[slot]) continue;
      CellKey key = keys[c];
      key.phase = phase;
      needs_.push_back({key, slot, cellsOf[c] / foundOf[c]});
    }
  }
}

void TileMap::place(uint32_t slot, const Brick& brick) {
  Slot& s = slots_[slot];
  s.brick = &brick;
  const int axis = system_ == System::warp ? 0 : 1;
  for (int l = 0; l < brick.levels(); ++l) {
    const Brick::Level& level = brick.level(l);
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
}

size_t TileMap::bytes() const {
  return (lowBits_.capacity() + highBits_.capacity()) * sizeof(uint16_t) + yarns_.capacity() * sizeof(PlacedYarn) +
         firstSlots_.capacity() * sizeof(uint32_t) + slots_.capacity() * sizeof(Slot) +
         needs_.capacity() * sizeof(Need);
}

}  // namespace loomlight
