#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/volume/tiles/tile_map.h"

namespace loomlight {

/// In which phases the cells of one yarn of the repeat occur in the piece, and how often.
class TileMap::PhaseCounts {
 public:
  PhaseCounts(const TileMap& map, int row);

  /// Adds the cell at `along` to the counts of a shape by phase; or takes it away, `sign` being -1 (modulo 2^64).
  void add(int along, uint64_t* cellsOf, uint64_t sign = 1) const;
  /// Adds all cells of the yarn to the counts of all shapes, by phaseIndex().
  void addAll(std::span<uint64_t> cellsOf) const;

 private:
  /// Of the first cell of the repeat: how often it occurs in which phases; those of others are so many further on.
  struct Occurrences {
    int phases = 0;
    std::array<int, kMaxPeriod> phase{};
    std::array<uint64_t, kMaxPeriod> cells{};
  };
  Occurrences count(const std::array<uint64_t, kMaxPeriod>& starts, int64_t repeats) const;
  void addSpan(int from, int to, const Occurrences& occurrences, std::span<uint64_t> cellsOf) const;

  const TileMap& map_;
  uint32_t row_;
  int period_;
  int more_;  ///< so many cells near the start of the repeat occur once more than those near its end
  Occurrences fewer_, often_;
};

}  // namespace loomlight
