#include "core/geometry/crossing.h"

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

double mass(const YarnGeometry& yarn) {
  return yarn.fibreArea_mm2 * yarn.fibreDensity_g_cm3;
}

}  // namespace

Crossing cross(const YarnGeometry& warp, const YarnGeometry& weft, double balance) {
  constexpr double kYielding = 2.5;
  const double toOne = std::pow(warp.pitch_mm / weft.pitch_mm, kYielding) * std::pow(mass(weft) / mass(warp), 2);
  const double warpShare = 1 - 1 / (1 + balance * toOne);
  const double warpMost = 0.5 * steepestClimb_mm(warp.pitch_mm), weftMost = 0.5 * steepestClimb_mm(weft.pitch_mm);
  Crossing c;
  for (size_t state = 0; state < kFloatStates; ++state) {
    const double apart = warp.rest_mm[state] + weft.rest_mm[state];
    double& warpHeight = c.warpHeight_mm[state];
    double& weftHeight = c.weftHeight_mm[state];
    warpHeight = std::min(apart * warpShare, warpMost);
    weftHeight = std::min(apart - warpHeight, weftMost);
    warpHeight = std::min(apart - weftHeight, warpMost);
  }
  return c;
}

}  // namespace loomlight
