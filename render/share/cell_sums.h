#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/units.h"
#include "render/film/zero_allocator.h"
#include "render/share/light_cell_key.h"

namespace loomlight {

/// How much light comes from the cells of a cloth (light_cell_key.h): sums of what paths have brought from there, in
/// every cell and in all that it lies in. The sums are integers, so they do not depend on the order of what is added.
/// Memory is taken from a fixed limit: where there is no room for a cell, its light is in the next coarser one alone,
/// which depends on the order of new cells, so they come in an order of their own: tile by tile, never as threads
/// finish. The finer a level is, the less of the room it may fill, so that a cloth of many voxels still finds cells for
/// the ways that it lies.
class CellSums {
 public:
  static constexpr size_t kLimit_bytes = size_t{64} << 20;

  explicit CellSums(size_t limit_bytes = kLimit_bytes);

  /// The finest cell, where it is known. Safe from many threads while nothing is added.
  std::optional<uint32_t> find(const LightCellPath& path) const;
  /// Whether light is known of the cell of this key.
  bool knows(uint64_t key) const;
  /// The finest of the cells that is known; none where no light is known at all.
  std::optional<uint32_t> nearest(const LightCellPath& path) const;
  /// Makes the cells that are not there yet; returns the finest that there is room for.
  uint32_t add(const LightCellPath& path);
  /// Light that a path has brought from there: to the cell and to all that it lies in.
  void deposit(uint32_t cell, Rgb colour);
  /// Lets the finest cells count for so many paths at most, on the average, and all others in proportion: what they
  /// know is of a picture before an edit.
  void fade(uint32_t mostPaths);
  /// Makes room: of the cells those of most paths are left, so many at most. What the others know is also in those that
  /// they lie in. Cells have other numbers then.
  void keep(size_t most);

  size_t size() const { return size_; }
  /// That it and its CellMeans take at most, whatever comes; not above the limit. While means are made they take half
  /// as much again.
  size_t bytes() const { return bytes_; }
  /// While there are fewer cells in all, those of this level may be added.
  size_t roomFor(int level) const;

  struct Cell {
    uint64_t key;
    int64_t colour[3];  ///< sum, in quanta; negative where colours are outside of the gamut
    uint64_t squares;   ///< sum over channels too, in quanta of their own, modulo 2^64
    uint32_t wraps;     ///< how often `squares` has come round
    uint32_t paths;
    uint32_t parent;  ///< always before the cell; of the first cell itself
    int level() const { return static_cast<int>(key & kLightCellLevelMask); }
    glm::dvec3 sum() const;
    double sumOfSquares() const;
    void addSquares(uint64_t quanta) {
      squares += quanta;
      wraps += squares < quanta;
    }
  };
  const Cell& operator[](uint32_t cell) const { return cells_[cell]; }

 private:
  size_t slotOf(uint64_t key) const;
  std::optional<uint32_t> find(uint64_t key) const;
  std::optional<uint32_t> make(uint64_t key, uint32_t parent);

  std::vector<Cell, ZeroAllocator<Cell>> cells_;          ///< pages are taken as they are used
  std::vector<uint32_t, ZeroAllocator<uint32_t>> slots_;  ///< open addressing; cell + 1, 0: free
  size_t size_ = 0, bytes_ = 0;
};

/// What light comes from each cell, as well as it is known: cells of many paths say so themselves, those of few are
/// drawn towards the one that they lie in (empirical Bayes). How far is estimated from the sums themselves, level by
/// level: the more alike cells of one parent are beside their noise, the more paths the parent counts for. Where light
/// or weave makes no difference at a level, it is as if the level were not there.
class CellMeans {
 public:
  explicit CellMeans(const CellSums& sums);

  struct Mean {
    Rgb colour{0};
    float square = 0;  ///< expected |colour|^2 of one path

    void operator+=(const Mean& other) {
      colour += other.colour;
      square += other.square;
    }
  };
  const Mean& operator[](uint32_t cell) const { return means_[cell]; }
  /// How many paths of its own a cell of this level needs, to count for as much as the one that it lies in.
  double parentWorth_paths(int level) const { return worth_[static_cast<size_t>(level)]; }

 private:
  std::vector<Mean> means_;
  std::array<double, kLightCellLevels> worth_{};
};

}  // namespace loomlight
