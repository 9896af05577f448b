#include "core/geometry/crossing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace loomlight {

namespace {

/// Heights that a system's path can reach: with its full radii, arc meeting arc, 2 h = 2 R - sqrt(4 R^2 - pitch^2); and
/// at the steepest, with shrunken radii, 2 h = pitch tan(steepest / 2).
struct Room {
  double free_mm, most_mm;
  Room(double pitch_mm, double radius_mm) : most_mm(0.5 * pitch_mm * std::tan(kSteepestPath / 2)) {
    const double gap = 4 * radius_mm * radius_mm - pitch_mm * pitch_mm;
    free_mm = gap > 0 ? std::min(most_mm, radius_mm - 0.5 * std::sqrt(gap)) : most_mm;
  }
};

}  // namespace

Crossing cross(const YarnGeometry& warp, const YarnGeometry& weft) {
  const double warpTop = warp.halfHeight_mm * warp.contactShare(), warpSide = warp.halfWidth_mm * warp.contactShare();
  const double weftTop = weft.halfHeight_mm * weft.contactShare(), weftSide = weft.halfWidth_mm * weft.contactShare();
  Crossing c;
  c.warpRadius_mm = warpTop + std::min(weftTop, weftSide);
  c.weftRadius_mm = weftTop + std::min(warpTop, warpSide);
  c.warpFlat_mm = std::max(0.0, weftSide - weftTop);
  c.weftFlat_mm = std::max(0.0, warpSide - warpTop);

  const Room warpRoom(warp.pitch_mm, c.warpRadius_mm), weftRoom(weft.pitch_mm, c.weftRadius_mm);
  const double sum = warpTop + weftTop;
  c.warpHeight_mm = std::min(weftTop, warpRoom.free_mm);
  c.weftHeight_mm = std::min(sum - c.warpHeight_mm, weftRoom.free_mm);
  c.warpHeight_mm = std::min(sum - c.weftHeight_mm, warpRoom.free_mm);
  const double missing = sum - c.warpHeight_mm - c.weftHeight_mm;
  c.warpHeight_mm = std::min(c.warpHeight_mm + 0.5 * missing, warpRoom.most_mm);
  c.weftHeight_mm = std::min(sum - c.warpHeight_mm, weftRoom.most_mm);
  c.warpHeight_mm = std::min(sum - c.weftHeight_mm, warpRoom.most_mm);
  return c;
}

double floatRise_mm(const YarnGeometry& yarn, int distance) {
  static constexpr std::array<double, kMaxFloatDistance + 1> kRise = {0.0, 0.08, 0.13, 0.15};
  return kRise[static_cast<size_t>(std::min(distance, kMaxFloatDistance))] *
         std::min(yarn.halfHeight_mm, yarn.pitch_mm);
}

}  // namespace loomlight
