#pragma once

#include <cstdint>
#include <vector>

#include "core/base/task.h"
#include "core/geometry/cloth_geometry.h"
#include "core/volume/brick.h"

namespace loomlight {

/// Which brick each cell of one system's yarns has. Cells of equal key but for the phase form a shape class; a repeat
/// is a map of classes, and the phase of a cell is that of its yarn's first cell, counted on along the yarn. So a piece
/// of any size costs one repeat, two bytes a crossing as long as there are fewer than 65536 classes, and four bytes a
/// yarn.
class TileMap {
 public:
  /// A yarn's cells are addressed by its own index (end or pick), `across`, and where along it, `along` (pick or end).
  struct Slot {
    const Brick* brick = nullptr;  ///< null where the piece has no such cell
    bool reachesBelow = false;     ///< into the cell at across - 1
    bool reachesAbove = false;
  };
  /// A brick that the piece needs.
  struct Need {
    CellKey key;
    uint32_t slot = 0;
    double cells = 0;  ///< of the piece that have it; of a shape class they are shared evenly among its phases
  };

  TileMap() = default;
  /// Reads the keys of one repeat of `geometry`, or of the whole piece where that is smaller. Throws InputError where
  /// this is more than kMaxCrossings. Left empty when the task is stopped.
  TileMap(const ClothGeometry& geometry, System system, const Task& task);
  static constexpr double kMaxCrossings = 268435456;  ///< 2^28: the largest weave, 16384 x 16384

  const std::vector<Need>& needs() const { return needs_; }
  /// Gives a slot its brick, which the caller keeps alive.
  void place(uint32_t slot, const Brick& brick);

  /// 0 <= across < yarns of the piece, 0 <= along < cells of a yarn; inRepeat = along % repeatAlong().
  const Slot& at(int across, int along, int inRepeat) const {
    const PlacedYarn& yarn = yarns_[across];
    const uint32_t phase = (yarn.phase + static_cast<uint32_t>(along)) % yarn.period;
    return slots_[firstSlots_[classAt(yarn.row + static_cast<uint32_t>(inRepeat))] + phase];
  }
  int repeatAlong() const { return repeatAlong_; }
  bool anyReachesBelow() const { return anyReachesBelow_; }
  bool anyReachesAbove() const { return anyReachesAbove_; }

  size_t bytes() const;

 private:
  struct PlacedYarn {
    uint32_t row;            ///< where its crossings begin in the map of classes
    uint16_t phase, period;  ///< of its first cell
  };

  uint32_t classAt(uint32_t crossing) const {
    return highBits_.empty() ? lowBits_[crossing]
                             : lowBits_[crossing] | static_cast<uint32_t>(highBits_[crossing]) << 16;
  }
  std::vector<CellKey> readClasses(const ClothGeometry& geometry, const Task& task);
  void placeYarns(const ClothGeometry& geometry, const std::vector<CellKey>& keys);
  void findNeeds(const ClothGeometry& geometry, const std::vector<CellKey>& keys);

  System system_ = System::warp;
  int yarnCount_ = 0, cells_ = 0;  ///< of the piece: across, and along each yarn
  int repeatAcross_ = 1, repeatAlong_ = 1;
  std::vector<uint16_t> lowBits_, highBits_;  ///< class per crossing of the repeat, yarn by yarn
  std::vector<PlacedYarn> yarns_;             ///< of the piece
  std::vector<uint32_t> firstSlots_;          ///< per class; its phases follow
  std::vector<Slot> slots_;
  std::vector<Need> needs_;
  bool anyReachesBelow_ = false, anyReachesAbove_ = false;
};

}  // namespace loomlight
