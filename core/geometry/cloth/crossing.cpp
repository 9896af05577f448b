#include "core/geometry/cloth/crossing.h"

#include <algorithm>
#include <cmath>

namespace loomlight {
namespace {

/// How hard a yarn is to lift at a crossing, by its float state: as a beam under the loom's tension over one pitch.
/// Tension goes by the mass, and bending stiffness by its square (equal fibres).
double stiffness(const YarnGeometry& yarn, size_t floatState) {
  // Over tension, mm2 for a yarn of 1 g/m. A yarn that bends both ways is held level at both ends; a float hardly is.
  constexpr std::array<double, 2> kBending = {20, 1};
  const double mass_g_m = yarn.fibreArea_mm2 * yarn.fibreDensity_g_cm3;
  return mass_g_m / yarn.pitch_mm * (1 + kBending[floatState] * mass_g_m / (yarn.pitch_mm * yarn.pitch_mm));
}

}  // namespace

Crossing cross(const YarnGeometry& warp, const YarnGeometry& weft, double balance) {
  constexpr size_t kInFloat = kFloatStates - 1, kEnd = kInFloat - 1;
  const double warpMost = 0.5 * steepestClimb_mm(warp.pitch_mm), weftMost = 0.5 * steepestClimb_mm(weft.pitch_mm);
  Crossing c;
  for (size_t warpState = 0; warpState < kInFloat; ++warpState)
    for (size_t weftState = 0; weftState < kInFloat; ++weftState) {
      const double apart = warp.rest_mm[warpState] + weft.rest_mm[weftState];
      const double warpShare = 1 - 1 / (1 + balance * stiffness(weft, weftState) / stiffness(warp, warpState));
      double& warpHeight = c.warpHeight_mm[warpState][weftState];
      double& weftHeight = c.weftHeight_mm[weftState][warpState];
      warpHeight = std::min(apart * warpShare, warpMost);
      weftHeight = std::min(apart - warpHeight, weftMost);
      warpHeight = std::min(apart - weftHeight, warpMost);
    }
  const auto inFloat = [](double end, double rest, double otherEnd, double otherRest) {
    return std::max(end, rest + otherRest - std::max(otherEnd, otherRest));
  };
  const double warpEnd = c.warpHeight_mm[kEnd][kEnd], weftEnd = c.weftHeight_mm[kEnd][kEnd];
  const double warpRest = warp.rest_mm[kInFloat], weftRest = weft.rest_mm[kInFloat];
  c.warpHeight_mm[kInFloat].fill(std::min(inFloat(warpEnd, warpRest, weftEnd, weftRest), warpMost));
  c.weftHeight_mm[kInFloat].fill(std::min(inFloat(weftEnd, weftRest, warpEnd, warpRest), weftMost));
  // Beside the inside of a float a yarn lies as if both were in the same state.
  for (size_t state = 0; state < kInFloat; ++state) {
    c.warpHeight_mm[state][kInFloat] = c.warpHeight_mm[state][state];
    c.weftHeight_mm[state][kInFloat] = c.weftHeight_mm[state][state];
  }
  return c;
}

}  // namespace loomlight
