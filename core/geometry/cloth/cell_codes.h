#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/geometry/cloth/crossing.h"
#include "core/geometry/cloth/thread_kinds.h"
#include "core/geometry/yarn/crowding.h"

namespace loomlight {

/// What a yarn does in one crossing cell, as a number: the kind of thread that it is (thread_kinds.h), and of the nodes
/// before, in and after the cell the kind that is crossed, on which side, its float state, and which neighbour it leans
/// to. Cells of one code have one key, up to the phase.
using ShapeCode = uint64_t;

/// A ShapeCode taken apart.
struct CellShape {
  struct Node {
    int crossed = 0;  ///< kind of thread
    bool over = false;
    int floatState = 0;  ///< 0..kFloatStates - 1 (pressing.h)
    int otherState = 0;  ///< likewise, of the yarn that it crosses; where threads do not crowd, taken to be its own
    /// How much the yarn leans to the neighbour after it (or, below 0, before it), which no thread parts it from:
    /// kLeaning for the crossing here, 1 for each beside it, as it is too stiff to follow each. 0 where threads do not
    /// crowd.
    int leaning = 0;
  };
  int own = 0;  ///< kind of thread
  Node previous, here, next;
};
CellShape shapeOf(ShapeCode code);

/// Whose kinds of threads are whose: [system][kind of another cloth] is the kind here, -1 of those that the cloth does
/// not use.
using KindNames = std::array<std::vector<int>, 2>;
/// What a code of the other cloth is here.
ShapeCode renamed(System system, ShapeCode code, const KindNames& names);

/// A changed crossing changes the codes of cells that are so far away along its two yarns, and where threads crowd
/// along the yarns beside these, and no others.
inline constexpr int kCrossingReach = 2;

/// What a yarn crosses over the weave's repeat, and what the yarns before and after it do: for each crossing whether
/// the warp is over, as Weave::row() and Weave::columns() give it. The neighbours may be empty where threads do not
/// crowd.
struct YarnCrossings {
  std::span<const uint8_t> own, before, after;
};

/// Reads the codes of a cloth's cells from its weave and the order of its kinds of threads. The cloth goes on beyond
/// its edges as its repeat does.
class CellCodes {
 public:
  /// `kinds`: by system, those of ends and picks in their shortest repeat. `crowded`: whether yarns lean to their
  /// neighbours, which makes several times as many codes of a large pattern.
  CellCodes(const Weave& weave, std::array<std::vector<int>, 2> kinds, bool crowded);

  const Weave& weave() const { return weave_; }
  bool crowded() const { return crowded_; }
  int kind(System system, int index) const;  ///< of an end or a pick; any integer
  /// Smallest periods, in crossings, after which the codes repeat.
  int repeatEnds() const { return repeatEnds_; }
  int repeatPicks() const { return repeatPicks_; }

  /// The codes of codes.size() cells in a row along a yarn, from cell `along` on; much cheaper than one by one.
  void read(System system, int across, int along, std::span<ShapeCode> codes) const;
  /// Codes of cells in a row from the crossings along the yarn. Cheaper still for many cells of an end, whose crossings
  /// lie apart in the weave.
  void read(System system, int across, int along, const YarnCrossings& crossings, std::span<ShapeCode> codes) const;

 private:
  const std::vector<int>& kinds(System system) const { return kinds_[static_cast<size_t>(system)]; }
  template <class WarpOver, class BesideAt>
  void readOf(System system, int across, int along, const WarpOver& warpOver, const BesideAt& besideAt,
              std::span<ShapeCode> codes) const;

  Weave weave_;
  std::array<std::vector<int>, 2> kinds_;
  bool crowded_ = false;
  int repeatEnds_ = 1, repeatPicks_ = 1;
};

}  // namespace loomlight
