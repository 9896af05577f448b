#include "core/volume/pool/component.h"

// How it works. A direction is projected onto the octahedron |x| + |y| + |z| = 1 and unfolded into a square (Meyer
// et al. 2010), of which the upper half is enough for lines. The map is not conformal, so that of the four codes
// around a direction the nearest is taken (Cigolle et al. 2014). A length density is the upper bits of a float,
// rounded. Eight are encoded side by side. Cost: some hundred vector operations for eight.

namespace loomlight {
namespace {

/// 0..steps for 0..1; what lies beyond is cut off.
Int32x4 unitCode(Float64x4 value, double steps) {
  return truncated(least(most(value, Float64x4{}), broadcast<Float64x4>(1.0)) * steps + 0.5);
}

}  // namespace

Int32x8 Component::encodeDirections(const std::array<DistributionLanes, 2>& d) {
  constexpr float kCentre = kAxisCentre;
  const auto scaleOf = [](const DistributionLanes& of) {
    return kAxisCentre / (magnitude(of.x) + magnitude(of.y) + magnitude(of.z));
  };
  const Float64x4 scales[] = {scaleOf(d[0]), scaleOf(d[1])};
  Float32x8 x = joined(d[0].x * scales[0], d[1].x * scales[1]);
  Float32x8 y = joined(d[0].y * scales[0], d[1].y * scales[1]);
  Float32x8 z = joined(d[0].z * scales[0], d[1].z * scales[1]);
  // Of the two directions of a line, the one in the upper half-space; on its rim, the one towards +x, then +y.
  const Int32x8 lower = (z < 0) | ((z == 0) & ((x < 0) | ((x == 0) & (y < 0))));
  x = lower ? -x : x;
  y = lower ? -y : y;
  z = lower ? -z : z;
  const auto floorOf = [](Float32x8 a) {  // a >= -kCentre
    const Int32x8 whole = __builtin_convertvector(a + (kCentre + 1), Int32x8);
    return __builtin_convertvector(whole, Float32x8) - (kCentre + 1);
  };
  const Float32x8 u = floorOf(x + y), v = floorOf(x - y);

  // The map is not conformal, so the nearest code is not always the rounded one: compare the four around it, by the
  // square of the sine of the angle between.
  const Float32x8 last = Float32x8{} + kCentre;
  Float32x8 bestU{}, bestV{}, bestSine = Float32x8{} + 1, bestSquare{};
  for (int corner = 0; corner < 4; ++corner) {
    const Float32x8 i = least(u + static_cast<float>(corner & 1), last);
    const Float32x8 j = least(v + static_cast<float>(corner >> 1), last);
    const Float32x8 cx = i + j, cy = i - j, cz = 2 * (kCentre - most(magnitude(i), magnitude(j)));
    const Float32x8 nx = cy * z - cz * y, ny = cz * x - cx * z, nz = cx * y - cy * x;
    const Float32x8 sine = nx * nx + ny * ny + nz * nz, square = cx * cx + cy * cy + cz * cz;
    const Int32x8 better = sine * bestSquare < bestSine * square;
    bestU = better ? i : bestU;
    bestV = better ? j : bestV;
    bestSine = better ? sine : bestSine;
    bestSquare = better ? square : bestSquare;
  }
  // On the rim a line has two codes.
  const Float32x8 sum = bestU + bestV;
  const Int32x8 turned =
      (most(magnitude(bestU), magnitude(bestV)) == kCentre) & ((sum < 0) | ((sum == 0) & (bestU < 0)));
  const Int32x8 i = __builtin_convertvector(turned ? -bestU : bestU, Int32x8);
  const Int32x8 j = __builtin_convertvector(turned ? -bestV : bestV, Int32x8);
  return (i + kAxisCentre) | (j + kAxisCentre) << 12;
}

Int32x4 Component::encodeDensity(Float64x4 lengthDensity) {
  constexpr int kDroppedBits = 12;  // of the 23 of a float's mantissa
  const Float32x4 density = __builtin_convertvector(most(lengthDensity, Float64x4{}), Float32x4);
  const Int32x4 excess = reinterpret_cast<Int32x4>(density) - static_cast<int>(kDensityBias);
  const Int32x4 rounded = (excess + (1 << (kDroppedBits - 1))) >> kDroppedBits;
  // Code 0 is zero, so what would round to the value of code 0 goes to the nearer of zero and code 1.
  const Int32x4 least = density >= 0x1p-13f ? Int32x4{1, 1, 1, 1} : Int32x4{};
  const Int32x4 code = rounded > 0 ? rounded : least;
  return code < 0xFFFF ? code : Int32x4{} + 0xFFFF;
}

void Component::encode(const std::array<DistributionLanes, 2>& distributions, Component* eight) {
  const Int32x8 directions = encodeDirections(distributions);
  for (int half = 0; half < 2; ++half) {
    const DistributionLanes& d = distributions[half];
    const Int32x4 spreads = unitCode(squareRoot(most(d.spread, Float64x4{})), 255);
    const Int32x4 densities = encodeDensity(d.lengthDensity);
    for (int i = 0; i < kLanes<Float64x4>; ++i) {
      const uint32_t bits = static_cast<uint32_t>(directions[half * kLanes<Float64x4> + i] | spreads[i] << 24);
      Component& component = eight[half * kLanes<Float64x4> + i];
      component = {};
      component.directionAndSpread_ = bits;
      component.density_ = static_cast<uint16_t>(densities[i]);
    }
  }
}

Component Component::encode(const FibreDistribution& d) {
  const DistributionLanes same{.x = broadcast<Float64x4>(d.direction.x),
                               .y = broadcast<Float64x4>(d.direction.y),
                               .z = broadcast<Float64x4>(d.direction.z),
                               .spread = broadcast<Float64x4>(d.spread),
                               .lengthDensity = broadcast<Float64x4>(d.lengthDensity)};
  Component eight[kLanes<Float32x8>];
  encode({same, same}, eight);
  return eight[0];
}

}  // namespace loomlight
