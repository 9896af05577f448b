#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/modulo.h"
#include "core/base/shared_list.h"
#include "core/base/task.h"
#include "core/fabric/weave/weave_edit.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "core/geometry/cloth/weave_changes.h"
#include "core/volume/pool/brick_table.h"

namespace loomlight {

class ShapeTable;

/// Which brick each cell of one system's yarns has. Cells of equal key but for phase and stretch are of one shape; a
/// repeat is a map of shapes; the phase of a cell is that of its yarn's first cell, counted on along the yarn, and so
/// is its stretch of the yarn's spool. So a piece of any size costs one repeat, two bytes a crossing as long as there
/// are fewer than 65536 shapes, and eight bytes a yarn. Copies share the map, yarn by yarn, until one of them is
/// edited.
class TileMap {
 public:
  /// A yarn's cells are addressed by its own index (end or pick), `across`, and where along it, `along` (pick or end).
  /// Of cells: a shape in one phase, of an uneven yarn in one kind of stretch. All of a kind have one brick.
  struct Kind {
    uint32_t shape = 0;
    int phase = 0;
    int stretch = 0;  ///< Spool::kind(); 0 of even yarns
  };

  TileMap() = default;
  /// Reads the shapes of one repeat of `geometry`, or of the whole piece where that is smaller; all bricks are missing,
  /// and will be of `pool`.
  /// Throws InputError where this is more than kMaxCrossings, or of a million shapes. Left empty when the task is
  /// stopped.
  TileMap(const ClothGeometry& geometry, System system, std::shared_ptr<BrickPool> pool, const Task& task);
  static constexpr double kMaxCrossings = 268435456;  ///< 2^28: the largest weave, 16384 x 16384

  /// How a cloth came out of another.
  struct Change {
    const ClothGeometry& before;
    bool inWeaveAlone = false;          ///< ClothGeometry::differsInWeaveOnly()
    KindNames names;                    ///< of the kinds of threads of `before`
    std::vector<WeaveCrossing> places;  ///< changes of the weave, as of weaveChanges()
  };
  /// Makes it the map of another geometry, as a new map would be, but for the bricks: those of shapes that are still
  /// there stay. Costs a copy of the shapes of each yarn that a place lies on, and where threads crowd of those beside.
  /// Where the repeat has another size, what its parts have in common is copied (of crowded cloth with more or fewer
  /// yarns nothing) and the rest is read; where a yarn has another period, or the piece or its
  /// repeat another size, all cells are counted again. Half-done, and of no use, when the task is stopped.
  void edit(const ClothGeometry& geometry, const Change& change, const Task& task);
  /// Whether most of its shapes are of former edits: time to read it anew.
  bool isWorn() const;

  /// All shapes there are, and some that there were before an edit; their keys have phase and stretch 0.
  const std::vector<YarnCellKey>& shapes() const { return shapes_; }
  YarnCellKey key(Kind kind) const;
  /// Of the piece; of an uneven yarn how many there would be, were the piece so large that every stretch of the spool
  /// is in it.
  double cells(Kind kind) const;
  /// BrickPool::kNone where it is missing, and where the piece has no cell of that shape and phase.
  BrickPool::Id brick(Kind kind) const { return bricks_[index(kind)]; }
  std::vector<Kind> missing() const;
  /// The missing kinds in the order in which a picture of these crossings of the piece needs them. With the first
  /// `sketch`, and standIn(), every cell that is seen has a brick of its shape, perhaps of another phase; with the
  /// first `seen`, each has its own; the rest is not seen.
  struct Wanted {
    std::vector<Kind> kinds;
    size_t sketch = 0, seen = 0;
  };
  Wanted missing(const CellRect& inView) const;
  /// Gives kinds whose bricks are missing those of others: of the same shape, or else the most similar one. Afterwards
  /// the map is for show: its bricks are not those of its keys.
  void standIn();
  std::vector<ClothGeometry::CellCount> cellCounts() const;  ///< of the piece, by shape
  /// visit(kind), of every kind that there may be, in order.
  template <class Visit>
  void forEachKind(const Visit& visit) const {
    for (uint32_t shape = 0; shape < shapes_.size(); ++shape)
      for (int phase = 0; phase < kMaxPeriod; ++phase)
        for (int stretch = 0; stretch < stretchKinds_; ++stretch) visit(Kind{shape, phase, stretch});
  }
  void place(Kind kind, BrickPool::Id brick) { bricks_.place(index(kind), brick); }
  /// All are missing then; those to come are of this pool.
  void dropBricks(std::shared_ptr<BrickPool> pool) { bricks_.clear(std::move(pool)); }

  /// 0 <= across < yarns of the piece, 0 <= along < cells of a yarn. The brick of the cell: four reads that wait for
  /// one another, two more where yarns are uneven, no division.
  const BrickPool::Entry& at(int across, int along) const { return bricks_.entry(indexAt(across, along)); }
  BrickPool::Id brickAt(int across, int along) const { return bricks_[indexAt(across, along)]; }
  bool anyReachesBelow() const { return bricks_.anyReachesBelow(); }
  bool anyReachesAbove() const { return bricks_.anyReachesAbove(); }

  /// Without the bricks. What is shared with other maps counts.
  size_t bytes() const;
  /// With the bricks, but without the rows and bricks that `other` has in the same places.
  size_t bytesBeside(const TileMap& other) const;
  /// Holds in common with `other` the rows that are the same.
  void shareRows(const TileMap& other);

 private:
  /// The shapes along a yarn of the repeat: the low bits of their numbers, and the high ones where there are any.
  struct Row {
    explicit Row(std::span<const uint32_t> shapes);
    Row(const Row& other, size_t size);  ///< as much of the other as there is, then shape 0
    std::vector<uint16_t> low, high;
    size_t bytes() const { return sizeof(Row) + (low.capacity() + high.capacity()) * sizeof(uint16_t); }
    bool operator==(const Row&) const = default;
    uint32_t at(size_t i) const { return low[i] | (high.empty() ? 0 : static_cast<uint32_t>(high[i]) << 16); }
    void set(size_t i, uint32_t shape);
    void set(size_t from, std::span<const uint32_t> shapes);
  };
  struct PlacedYarn {
    uint32_t row;           ///< which yarn of the repeat it is
    uint16_t stretch;       ///< of its first cell
    uint8_t phase, period;  ///< of its first cell
    bool operator==(const PlacedYarn&) const = default;
  };
  /// What of a former map's rows stands as it is: the cells [from, to) of the first so many yarns; or all their cells,
  /// and there are no others.
  struct Kept {
    int yarns = 0, from = 0, to = 0;
    bool wholeRows = false;
  };
  class PhaseCounts;
  struct Band;
  /// [period]
  static constexpr auto kByPeriod = [] {
    std::array<Modulo, kMaxPeriod + 1> all;
    for (uint32_t period = 1; period < all.size(); ++period) all[period] = Modulo(period);
    return all;
  }();

  std::vector<bool> kindsIn(const CellRect& rect) const;
  bool hasBrick(uint32_t shape) const;
  size_t indexAt(int across, int along) const {
    const PlacedYarn& yarn = yarns_[across];
    const auto cell = static_cast<uint32_t>(along);
    const uint32_t phase = kByPeriod[yarn.period](yarn.phase + cell);
    const size_t brick = phaseIndex(shapeAt(yarn.row, inRepeat_(cell)), static_cast<int>(phase));
    if (stretchKinds_ == 1) return brick;
    const Spool* const spool = spoolOf_[yarn.row];
    const uint32_t stretch = yarn.stretch + kByPeriod[yarn.period].quotient(yarn.phase + cell);
    return brick * stretchKinds_ + (spool ? spool->kind(stretch) : 0);
  }
  static size_t phaseIndex(uint32_t shape, int phase) { return static_cast<size_t>(shape) * kMaxPeriod + phase; }
  size_t index(Kind kind) const { return phaseIndex(kind.shape, kind.phase) * stretchKinds_ + kind.stretch; }
  uint32_t shapeAt(uint32_t row, uint32_t inRepeat) const {
    const uint32_t low = low_[row][inRepeat];
    return high_.empty() || !high_[row] ? low : low | static_cast<uint32_t>(high_[row][inRepeat]) << 16;
  }
  void pointTo(size_t number, const Row& row);
  void findExtent(const ClothGeometry& geometry);
  void placeYarns(const ClothGeometry& geometry);
  void takeSpools(const ClothGeometry& geometry);
  size_t spoolBytes() const;
  void readRows(const ClothGeometry& geometry, const Task& task, const Kept& kept, ShapeTable& table);
  void readBand(const ClothGeometry& geometry, const Task& task, const Kept& kept, Band& band) const;
  static void renumber(Band& band, ShapeTable& all);
  void countCells(const Task& task);
  Kept keptOf(const ClothGeometry& geometry, const ClothGeometry& before, int formerAcross, int formerAlong) const;
  bool reshape(const ClothGeometry& geometry, const Change& change, const Task& task, ShapeTable& table);
  void editRow(const ClothGeometry& geometry, int across, std::span<const int> places, bool counting,
               ShapeTable& table);
  void addShapes(const ShapeTable& table);

  System system_ = System::warp;
  int yarnCount_ = 0, cells_ = 0;  ///< of the piece: across, and along each yarn
  int repeatAcross_ = 1, repeatAlong_ = 1;
  Modulo inRepeat_;                            ///< by repeatAlong_
  std::shared_ptr<const PlacedYarn[]> yarns_;  ///< of the piece
  SharedList<Row> rows_;                       ///< per yarn of the repeat
  std::vector<const uint16_t*> low_, high_;    ///< of each row; `high_` is empty where no row has any
  std::vector<YarnCellKey> shapes_;
  std::vector<ShapeCode> codes_;                      ///< one of each shape
  int stretchKinds_ = 1;                              ///< that any of the yarns has
  std::vector<std::shared_ptr<const Spool>> spools_;  ///< by geometry class; null of even yarns
  std::vector<const Spool*> spoolOf_;                 ///< per yarn of the repeat; empty where all are even
  std::vector<uint64_t> cellsOf_;                     ///< by phaseIndex()
  BrickTable bricks_;                                 ///< by index()
};

}  // namespace loomlight
