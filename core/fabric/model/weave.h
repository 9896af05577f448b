#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/fabric/model/unknown_keys.h"

namespace loomlight {

/// The weave matrix of one repeat: cell (pick, end) is 1 where the warp end lies over the weft pick. Picks count up
/// along the warp (+y), ends along the weft (+x), both from 0. An immutable value, a pointer to copy: `with...`
/// make a changed one that shares every untouched pick, so an edit of a 4000 x 4000 jacquard costs one row and the list
/// of rows.
class Weave {
 public:
  static constexpr int kMaxSide = 16384;
  using Row = std::vector<uint8_t>;
  using SharedRow = std::shared_ptr<const Row>;

  /// Plain weave, 2 x 2.
  Weave();
  /// `rows[p][e]` is 1 for warp over. All rows the same length; 1..kMaxSide on both sides (asserted: files are checked
  /// where they are read).
  explicit Weave(const std::vector<Row>& rows);
  /// The same, of rows that may be shared: by picks of one shed, or with another weave.
  explicit Weave(std::vector<SharedRow> rows);

  int ends() const { return ends_; }
  int picks() const { return picks_; }

  /// Any integers: the repeat goes on for ever in both directions.
  bool warpOver(int pick, int end) const;
  /// Within the repeat only: 0 <= pick < picks(), 0 <= end < ends(). The hot path.
  bool at(int pick, int end) const { return (*rows_[pick])[end] != 0; }
  std::span<const uint8_t> row(int pick) const { return *rows_[pick]; }
  /// The same, for another weave to share.
  const SharedRow& sharedRow(int pick) const { return rows_[pick]; }

  Weave with(int pick, int end, bool warpOver) const;
  /// Another size of repeat: what fits is kept, the new cells continue the old repeat.
  Weave resized(int ends, int picks) const;

  /// What `count` ends cross, one end after the other, picks() cells each; end `first` + i is counted modulo ends().
  std::vector<uint8_t> columns(int first, int count) const;

  friend bool operator==(const Weave& a, const Weave& b);

 private:
  using Rows = std::shared_ptr<const SharedRow[]>;
  std::span<const SharedRow> rows() const { return {rows_.get(), static_cast<size_t>(picks_)}; }

  int ends_ = 0, picks_ = 0;
  Rows rows_;
};

/// Of each end, treadle or pick, the numbers of its shafts or treadles.
using NumberLists = std::vector<std::vector<int>>;

/// Threading, tie-up and treadling (or a liftplan): how a loom makes a weave. Shafts and treadles count from 1, as
/// weavers and WIF files do; 0 or an empty list means none.
struct Draft {
  int shafts = 0;
  int treadles = 0;
  NumberLists threading;   ///< per end: the shafts it hangs on, usually one
  NumberLists tieUp;       ///< per treadle: the shafts tied to it
  NumberLists treadling;   ///< per pick: the treadles pressed
  NumberLists liftplan;    ///< per pick: the shafts raised; used instead of tie-up where not empty
  bool risingShed = true;  ///< false: a tied shaft is pulled down (sinking shed)

  UnknownKeys unknown;
  friend bool operator==(const Draft&, const Draft&);
};

/// The shafts that a pick pulls on, each once and in order; numbers of no shaft or treadle are passed over. Rising, or
/// with a liftplan, they go up; in a sinking shed they go down.
std::vector<int> pulledShafts(const Draft& draft, size_t pick);

/// The weave that the draft makes: an end is up where one of its shafts is tied to one of the pick's treadles, or is in
/// the pick's lift. A sinking shed complements that, a liftplan never does; an end on no shaft is never up. Shafts and
/// treadles that the loom does not have are passed over. Needs 1..Weave::kMaxSide ends and picks (asserted).
Weave drawdown(const Draft& draft);

}  // namespace loomlight
