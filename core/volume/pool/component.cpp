#include "core/volume/pool/component.h"

namespace loomlight {
namespace {

/// 0..steps for 0..1; what lies beyond is cut off.
IntLanes unitCode(Lanes value, double steps) {
  return truncated(least(most(value, Lanes{}), inAllLanes(1)) * steps + 0.5);
}

}  // namespace

WideInts Component::encodeDirections(const std::array<DistributionLanes, 2>& d) {
  constexpr float kCentre = kAxisCentre;
  const auto scaleOf = [](const DistributionLanes& of) {
    return kAxisCentre / (magnitude(of.x) + magnitude(of.y) + magnitude(of.z));
  };
  const Lanes scales[] = {scaleOf(d[0]), scaleOf(d[1])};
  WideFloats x = joined(d[0].x * scales[0], d[1].x * scales[1]);
  WideFloats y = joined(d[0].y * scales[0], d[1].y * scales[1]);
  WideFloats z = joined(d[0].z * scales[0], d[1].z * scales[1]);
  // Of the two directions of a line, the one in the upper half-space; on its rim, the one towards +x, then +y.
  const WideInts lower = (z < 0) | ((z == 0) & ((x < 0) | ((x == 0) & (y < 0))));
  x = lower ? -x : x;
  y = lower ? -y : y;
  z = lower ? -z : z;
  const auto floorOf = [](WideFloats a) {  // a >= -kCentre
    const WideInts whole = __builtin_convertvector(a + (kCentre + 1), WideInts);
    return __builtin_convertvector(whole, WideFloats) - (kCentre + 1);
  };
  const WideFloats u = floorOf(x + y), v = floorOf(x - y);

  // The map is not conformal, so the nearest code is not always the rounded one: compare the four around it, by the
  // square of the sine of the angle between.
  const WideFloats last = WideFloats{} + kCentre;
  WideFloats bestU{}, bestV{}, bestSine = WideFloats{} + 1, bestSquare{};
  for (int corner = 0; corner < 4; ++corner) {
    const WideFloats i = least(u + static_cast<float>(corner & 1), last);
    const WideFloats j = least(v + static_cast<float>(corner >> 1), last);
    const WideFloats cx = i + j, cy = i - j, cz = 2 * (kCentre - most(magnitude(i), magnitude(j)));
    const WideFloats nx = cy * z - cz * y, ny = cz * x - cx * z, nz = cx * y - cy * x;
    const WideFloats sine = nx * nx + ny * ny + nz * nz, square = cx * cx + cy * cy + cz * cz;
    const WideInts better = sine * bestSquare < bestSine * square;
    bestU = better ? i : bestU;
    bestV = better ? j : bestV;
    bestSine = better ? sine : bestSine;
    bestSquare = better ? square : bestSquare;
  }
  // On the rim a line has two codes.
  const WideFloats sum = bestU + bestV;
  const WideInts turned =
      (most(magnitude(bestU), magnitude(bestV)) == kCentre) & ((sum < 0) | ((sum == 0) & (bestU < 0)));
  const WideInts i = __builtin_convertvector(turned ? -bestU : bestU, WideInts);
  const WideInts j = __builtin_convertvector(turned ? -bestV : bestV, WideInts);
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

void Component::encode(const std::array<DistributionLanes, 2>& distributions, Component* eight) {
  const WideInts directions = encodeDirections(distributions);
  for (int half = 0; half < 2; ++half) {
    const DistributionLanes& d = distributions[half];
    const IntLanes spreads = unitCode(squareRoot(most(d.spread, Lanes{})), 255);
    const IntLanes densities = encodeDensity(d.lengthDensity);
    for (int i = 0; i < kLanes; ++i) {
      const uint32_t bits = static_cast<uint32_t>(directions[half * kLanes + i] | spreads[i] << 24);
      Component& component = eight[half * kLanes + i];
      component.low_ = static_cast<uint16_t>(bits);
      component.high_ = static_cast<uint16_t>(bits >> 16);
      component.density_ = static_cast<uint16_t>(densities[i]);
    }
  }
}

Component Component::encode(const FibreDistribution& d) {
  const DistributionLanes same{.x = inAllLanes(d.direction.x),
                               .y = inAllLanes(d.direction.y),
                               .z = inAllLanes(d.direction.z),
                               .spread = inAllLanes(d.spread),
                               .lengthDensity = inAllLanes(d.lengthDensity)};
  Component eight[kWide];
  encode({same, same}, eight);
  return eight[0];
}

}  // namespace loomlight
