#include "core/geometry/crossing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace loomlight {

Crossing cross(const YarnGeometry& warp, const YarnGeometry& weft) {
  Crossing c;
  // From +h to -h within one pitch, no steeper than the steepest: 2 h <= pitch tan(steepest / 2).
  const double room = 0.5 * std::tan(kSteepestPath / 2);
  const double warpRoom = room * warp.pitch_mm, weftRoom = room * weft.pitch_mm;
  const double sum = warp.halfHeight_mm + weft.halfHeight_mm;
  c.warpHeight_mm = std::min(weft.halfHeight_mm, warpRoom);
  c.weftHeight_mm = std::min(sum - c.warpHeight_mm, weftRoom);
  c.warpHeight_mm = std::min(sum - c.weftHeight_mm, warpRoom);

  const double warpEdge = std::min(warp.halfHeight_mm, warp.halfWidth_mm);
  const double weftEdge = std::min(weft.halfHeight_mm, weft.halfWidth_mm);
  c.warpRadius_mm = warp.halfHeight_mm + weftEdge;
  c.weftRadius_mm = weft.halfHeight_mm + warpEdge;
  c.warpFlat_mm = weft.halfWidth_mm - weftEdge;
  c.weftFlat_mm = warp.halfWidth_mm - warpEdge;
  return c;
}

double floatRise_mm(const YarnGeometry& yarn, int distance) {
  static constexpr std::array<double, kMaxFloatDistance + 1> kRise = {0.0, 0.08, 0.13, 0.15};
  return kRise[static_cast<size_t>(std::min(distance, kMaxFloatDistance))] *
         std::min(yarn.halfHeight_mm, yarn.pitch_mm);
}

}  // namespace loomlight
