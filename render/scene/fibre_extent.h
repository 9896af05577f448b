#pragma once

#include <limits>

#include "core/fabric/model/choice_names.h"
#include "render/scene/trace_data.h"

namespace loomlight {

/// How a cloth is laid fibre by fibre. wholePiece: all of it in one tree. oneRepeat: of a flat piece the crossings of
/// one repeat, which stand side by side over it. bricks: cell by cell, each laid once for all that are like it
/// (FibreBricks). automatic: the whole piece where memory is enough for it, else bricks.
enum class FibreExtent { automatic, wholePiece, oneRepeat, bricks };
template <>
struct ChoiceNames<FibreExtent> {
  static constexpr std::array names{"auto", "piece", "repeat", "bricks"};
};

struct FibreOptions {
  double limit_bytes = std::numeric_limits<double>::infinity();
  FibreExtent extent = FibreExtent::automatic;
  FibreOptions() = default;
  FibreOptions(double limit, FibreExtent which = FibreExtent::automatic) : limit_bytes(limit), extent(which) {}
};

/// What explicit fibres take: the crossings laid, from the piece's corner on, how often these stand side by side, and
/// what that needs, estimated before anything is made. Copies that reach beyond the piece end with it.
///
/// A repeat is one of the weave, of the yarns' shapes, and of the twist: a whole number of the periods of every yarn
/// that runs along it (YarnGeometry::period), so that each fibre goes on seamlessly in the next copy. In the piece
/// itself every yarn begins its twist where it likes and none repeats its neighbour; in copies the first ones' do. That
/// is another arrangement of the same yarns, and where nothing varies along yarns the very same cloth. Uneven yarns are
/// cut off after a decimetre, where their thickness and place have a step. Colours follow their sequences over the
/// whole piece.
struct FibreSize {
  int ends = 1, picks = 1;
  glm::ivec2 copies{1};
  double segments = 0;  ///< that are laid
  double bytes = 0;     ///< at most, while it is built
  bool bricks = false;  ///< of the whole piece, counted once for all cells that are alike

  bool isWholePiece() const { return copies == glm::ivec2(1); }
};

/// Of the extent that the options lead to. May be beyond their limit: then there is nothing smaller to lay. Throws
/// InputError where one repeat is asked of cloth that is not flat, and bricks of one that has none (TraceData::fibres).
FibreSize planFibres(const TraceData& cloth, const FibreOptions& options);

}  // namespace loomlight
