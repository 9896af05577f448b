#include "core/volume/tiles/phase_counts.h"

#include <algorithm>

// How it works. A yarn of the repeat comes again every repeat of the weave, in a phase of its twist that moves on by
// the repeat's length each time, modulo the yarn's period. So the counts of its first cell are made once, by phase,
// and those of every other cell are the same so many phases further on.

namespace loomlight {
namespace {

/// How many numbers in [0, total) leave the remainder r when divided by `period`.
int64_t countOfRemainder(int64_t total, int64_t period, int64_t r) {
  return (total - r + period - 1) / period;
}

}  // namespace

TileMap::PhaseCounts::PhaseCounts(const TileMap& map, int row)
    : map_(map),
      row_(static_cast<uint32_t>(row)),
      period_(map.yarns_[row].period),
      more_(map.cells_ % map.repeatAlong_) {
  std::array<uint64_t, kMaxPeriod> starts{};  // yarns of the piece by the phase of their first cell
  for (int across = row; across < map.yarnCount_; across += map.repeatAcross_) ++starts[map.yarns_[across].phase];
  const int repeats = map.cells_ / map.repeatAlong_;
  fewer_ = count(starts, repeats);
  if (more_ > 0) often_ = count(starts, repeats + 1);
}

TileMap::PhaseCounts::Occurrences TileMap::PhaseCounts::count(const std::array<uint64_t, kMaxPeriod>& starts,
                                                              int64_t repeats) const {
  std::array<uint64_t, kMaxPeriod> cells{};
  for (int64_t i = 0; i < std::min<int64_t>(repeats, period_); ++i)
    for (int start = 0; start < period_; ++start)
      cells[(start + i * map_.repeatAlong_) % period_] += starts[start] * countOfRemainder(repeats, period_, i);
  Occurrences occurrences;
  for (int phase = 0; phase < period_; ++phase) {
    if (cells[phase] == 0) continue;
    occurrences.phase[occurrences.phases] = phase;
    occurrences.cells[occurrences.phases++] = cells[phase];
  }
  return occurrences;
}

void TileMap::PhaseCounts::add(int along, uint64_t* cellsOf, uint64_t sign) const {
  const Occurrences& occurrences = along < more_ ? often_ : fewer_;
  for (int i = 0; i < occurrences.phases; ++i)
    cellsOf[(occurrences.phase[i] + along) % period_] += sign * occurrences.cells[i];
}

void TileMap::PhaseCounts::addAll(std::span<uint64_t> cellsOf) const {
  addSpan(0, more_, often_, cellsOf);
  addSpan(more_, map_.repeatAlong_, fewer_, cellsOf);
}

/// Of a large jacquard, this is done for every crossing. Its cells occur once or twice: in few phases.
void TileMap::PhaseCounts::addSpan(int from, int to, const Occurrences& occurrences,
                                   std::span<uint64_t> cellsOf) const {
  const uint16_t* const low = map_.low_[row_];
  const uint16_t* const high = map_.high_.empty() ? nullptr : map_.high_[row_];
  for (int i = 0; i < occurrences.phases; ++i) {
    const uint64_t cells = occurrences.cells[i];
    int phase = (occurrences.phase[i] + from) % period_;
    for (int along = from; along < to; ++along) {
      const uint32_t shape = low[along] | (high ? static_cast<uint32_t>(high[along]) << 16 : 0);
      cellsOf[phaseIndex(shape, phase)] += cells;
      if (++phase == period_) phase = 0;
    }
  }
}

}  // namespace loomlight
