#include "render/scene/fibre_extent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/base/error.h"
#include "render/scene/fibre_bricks.h"

// How it works. How many segments a crossing takes is measured on one repeat; from that follow the memory of the
// whole piece, of the fewest repeats that look like it, and of bricks of distinct cells. Where no extent is asked
// for, the first of piece, bricks and (on a flat drape) repeats that fits into the limit is taken.

namespace loomlight {
namespace {

// Measured resident, at their largest: our arrays 25-26 bytes a segment, Embree's 36-42; the estimate of segments is
// a few percent low.
constexpr double kTreeBytesPerSegment = 26 + 46;
constexpr double kBytesPerCopy = 400;

/// So that the arrangement of a few fibres does not decide how a wide cloth looks.
constexpr int64_t kMinCrossings = 16;

double segmentsPerCrossing(const ClothGeometry& geometry) {
  const double measured = static_cast<double>(std::min(geometry.repeatEnds(), geometry.ends())) *
                          std::min(geometry.repeatPicks(), geometry.picks());
  return geometry.measure().segmentsPerRepeat / measured;
}

FibreSize sizeOf(const ClothGeometry& geometry, double segmentsPerCrossing, int64_t ends, int64_t picks) {
  FibreSize size;
  size.ends = static_cast<int>(std::min<int64_t>(ends, geometry.ends()));
  size.picks = static_cast<int>(std::min<int64_t>(picks, geometry.picks()));
  size.copies = {(geometry.ends() + size.ends - 1) / size.ends, (geometry.picks() + size.picks - 1) / size.picks};
  size.segments = segmentsPerCrossing * size.ends * size.picks;
  const double copies = size.isWholePiece() ? 0.0 : static_cast<double>(size.copies.x) * size.copies.y;
  size.bytes = size.segments * kTreeBytesPerSegment + copies * kBytesPerCopy;
  return size;
}

/// Uneven yarns never repeat. They are cut off after as much, which has some of each of their thick and thin places.
constexpr double kCutOff_mm = 100;

/// Crossings along the yarns of a system after which all that they are made of repeats: at least kMinCrossings, at most
/// `piece`, which needs no repeat. Where yarns come again in the next tile, tiles.
int repeatAlong(const ClothGeometry& geometry, System system, int piece) {
  const bool warp = system == System::warp;
  const Tiling& tiling = geometry.yarns().tiling();
  const int tile = warp ? tiling.picks : tiling.ends;
  int64_t repeat = tile > 0 ? tile : warp ? geometry.repeatPicks() : geometry.repeatEnds();
  int64_t least = kMinCrossings;
  const int yarns =
      warp ? std::min(geometry.repeatEnds(), geometry.ends()) : std::min(geometry.repeatPicks(), geometry.picks());
  for (int i = 0; tile == 0 && i < yarns && repeat < piece; ++i) {
    const YarnCellKey key = warp ? geometry.key(system, 0, i) : geometry.key(system, i, 0);
    const YarnGeometry& yarn = geometry.yarn(system, key.yarn);
    repeat = std::lcm(repeat, static_cast<int64_t>(yarn.period));
    if (geometry.yarns().spool(system, key.yarn))
      least = std::max(least, static_cast<int64_t>(std::ceil(kCutOff_mm / yarn.pitch_mm)));
  }
  const int64_t crossings = (least + repeat - 1) / repeat * repeat;
  return static_cast<int>(std::min<int64_t>(crossings, piece));
}

FibreSize sizeOfRepeat(const ClothGeometry& geometry, double segmentsPerCrossing) {
  const int64_t ends = repeatAlong(geometry, System::weft, geometry.ends());
  const int64_t picks = repeatAlong(geometry, System::warp, geometry.picks());
  FibreSize size = sizeOf(geometry, segmentsPerCrossing, ends, picks);
  // Of a wide cloth several repeats are laid, where fewer copies save more than these cost.
  for (int64_t several = 2;; several *= 2) {
    const FibreSize larger = sizeOf(geometry, segmentsPerCrossing, several * ends, several * picks);
    if (larger.bytes >= size.bytes) return size;
    size = larger;
  }
}

FibreSize sizeOfBricks(const TraceData& cloth) {
  const ClothGeometry& geometry = cloth.volume->geometry();
  const auto segments = static_cast<double>(cloth.volume->counts().segments);
  return {geometry.ends(), geometry.picks(), glm::ivec2(1), segments, segments * FibreBricks::kBytesPerSegment, true};
}

}  // namespace

FibreSize planFibres(const TraceData& cloth, const FibreOptions& options) {
  const ClothGeometry& geometry = cloth.volume->geometry();
  const bool flat = cloth.shell->isFlat();
  if (options.extent == FibreExtent::oneRepeat && !flat)
    throw InputError("fibres: expected a flat drape for one repeat to stand for the piece; got one that is bent");
  if (options.extent == FibreExtent::bricks && !cloth.fibres)
    throw InputError(fmt::format("fibres: {} segments in cells that differ; expected at most {} for bricks",
                                 cloth.volume->counts().segments, FibreBricks::kMostSegments));
  const double each = segmentsPerCrossing(geometry);
  const FibreSize whole = sizeOf(geometry, each, geometry.ends(), geometry.picks());
  switch (options.extent) {
    case FibreExtent::wholePiece:
      return whole;
    case FibreExtent::oneRepeat:
      return sizeOfRepeat(geometry, each);
    case FibreExtent::bricks:
      return sizeOfBricks(cloth);
    case FibreExtent::automatic:
      break;
  }
  if (whole.bytes <= options.limit_bytes) return whole;
  if (cloth.fibres)
    if (const FibreSize bricks = sizeOfBricks(cloth); bricks.bytes <= options.limit_bytes) return bricks;
  return flat ? sizeOfRepeat(geometry, each) : whole;
}

}  // namespace loomlight
