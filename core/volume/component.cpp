#include "core/volume/component.h"

namespace loomlight {
namespace {

/// 0..steps for 0..1; what lies beyond is cut off.
IntLanes unitCode(Lanes value, double steps) {
  return truncated(least(most(value, Lanes{}), inAllLanes(1)) * steps + 0.5);
}

}  // namespace

IntLanes Component::encodeDirection(const DistributionLanes& d) {
  // Of the two unit vectors of a line, the one in the upper half-space; on its rim, the one towards +x, then +y.
  const LaneMask lower = (d.z < 0) | ((d.z == 0) & ((d.x < 0) | ((d.x == 0) & (d.y < 0))));
  const Lanes x = lower ? -d.x : d.x, y = lower ? -d.y : d.y, z = lower ? -d.z : d.z;
  const Lanes scale = kAxisCentre / (magnitude(x) + magnitude(y) + z);
  const auto floorOf = [](Lanes a) { return toLanes(truncated(a + (kAxisCentre + 1)) - (kAxisCentre + 1)); };
  const Lanes u = floorOf((x + y) * scale), v = floorOf((x - y) * scale);

  // The map is not conformal, so the nearest code is not always the rounded one: compare the four around it, by the
  // square of the sine of the angle between.
  Lanes bestU{}, bestV{}, bestSine = inAllLanes(1), bestSquare{};
  for (int corner = 0; corner < 4; ++corner) {
    const Lanes i = least(u + (corner & 1), inAllLanes(kAxisCentre)),
                j = least(v + (corner >> 1), inAllLanes(kAxisCentre));
    const Lanes cx = i + j, cy = i - j, cz = 2 * (kAxisCentre - most(magnitude(i), magnitude(j)));
    const Lanes nx = cy * z - cz * y, ny = cz * x - cx * z, nz = cx * y - cy * x;
    const Lanes sine = nx * nx + ny * ny + nz * nz, square = cx * cx + cy * cy + cz * cz;
    const LaneMask better = sine * bestSquare < bestSine * square;
    bestU = better ? i : bestU;
    bestV = better ? j : bestV;
    bestSine = better ? sine : bestSine;
    bestSquare = better ? square : bestSquare;
  }
  // On the rim a line has two codes.
  const Lanes sum = bestU + bestV;
  const LaneMask turned =
      (most(magnitude(bestU), magnitude(bestV)) == kAxisCentre) & ((sum < 0) | ((sum == 0) & (bestU < 0)));
  const IntLanes i = truncated(turned ? -bestU : bestU), j = truncated(turned ? -bestV : bestV);
  return (i + kAxisCentre) | (j + kAxisCentre) << 12;
}

IntLanes Component::encodeDensity(Lanes lengthDensity) {
  constexpr int kDroppedBits = 12;  // of the 23 of a float's mantissa
  const FloatLanes density = __builtin_convertvector(most(lengthDensity, Lanes{}), FloatLanes);
  const IntLanes excess = reinterpret_cast<IntLanes>(density) - static_cast<int>(kDensityBias);
  const IntLanes rounded = (excess + (1 << (kDroppedBits - 1))) >> kDroppedBits;
  // Code 0 is zero, so what would round to the value of code 0 goes to the nearer of zero and code 1.
  const IntLanes least = density >= 0x1p-13f ? IntLanes{1, 1, 1, 1} : IntLanes{};
  const IntLanes code = rounded > 0 ? rounded : least;
  return code < 0xFFFF ? code : IntLanes{} + 0xFFFF;
}

void Component::encode(const DistributionLanes& d, Component* four) {
  const IntLanes low = encodeDirection(d) | unitCode(squareRoot(most(d.spread, Lanes{})), 255) << 24;
  const IntLanes high = unitCode(d.packing, 255) | (d.material & 0xFF) << 8 | encodeDensity(d.lengthDensity) << 16;
  for (int i = 0; i < kLanes; ++i)
    four[i].bits_ = static_cast<uint32_t>(low[i]) | static_cast<uint64_t>(static_cast<uint32_t>(high[i])) << 32;
}

Component Component::encode(const FibreDistribution& d) {
  Component four[kLanes];
  encode({.x = inAllLanes(d.direction.x),
          .y = inAllLanes(d.direction.y),
          .z = inAllLanes(d.direction.z),
          .spread = inAllLanes(d.spread),
          .lengthDensity = inAllLanes(d.lengthDensity),
          .packing = inAllLanes(d.packing),
          .material = IntLanes{} + d.material},
         four);
  return four[0];
}

}  // namespace loomlight
