// The fibres of a voxel, as several rays come to them side by side: decoded, as they lie in the world, and what a ray
// meets of them. Compiled once for each instruction set, as lanes-inl.h is.
#if defined(LOOMLIGHT_FIBRE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LOOMLIGHT_FIBRE_LANES_INL_H_
#undef LOOMLIGHT_FIBRE_LANES_INL_H_
#else
#define LOOMLIGHT_FIBRE_LANES_INL_H_
#endif

#include "render/walk/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

/// FibreDistribution of each ray.
struct FibreLanes {
  Vector direction;
  Real spread, lengthDensity;
  Whole box;  ///< VoxelBox::code()
};

/// The components of these numbers.
HWY_INLINE FibreLanes decode(const Component* components, Whole number) {
  static_assert(sizeof(Component) == 8);
  const Whole byte = shiftedLeft<3>(number);
  const Whole bits = gatherBytes(components, byte), densityAndBox = gatherBytes(components, byte + Whole(4));
  const Whole density = densityAndBox & Whole(0xFFFF);
  const Real step(1.0f / Component::kAxisCentre);
  const Real u = toReal((bits & Whole(0xFFF)) - Whole(Component::kAxisCentre)) * step;
  const Real v = toReal((shiftedRight<12>(bits) & Whole(0xFFF)) - Whole(Component::kAxisCentre)) * step;
  const Real x = Real(0.5f) * (u + v), y = Real(0.5f) * (u - v);
  const Real z = Real(1.0f) - most(magnitude(u), magnitude(v));
  const Real scale = Real(1.0f) / squareRoot(x * x + y * y + z * z);
  const Real root = toReal(shiftedRight<24>(bits)) * Real(1.0f / 255.0f);
  const Real length = realOfBits(shiftedLeft<12>(density) + Whole(static_cast<int32_t>(Component::kDensityBias)));
  return {Vector{x, y, z} * scale, root * root, orZero(~(density == Whole(0)), length),
          shiftedRight<16>(densityAndBox)};
}

/// Of each ray, a component's box in widths of the voxel (VoxelBox); the whole voxel unless `boxed`.
struct BoxLanes {
  Mask boxed;
  Real lower[3], upper[3];

  HWY_INLINE BoxLanes(Mask holds, Whole code) : boxed(holds & ~(code == Whole(VoxelBox().code()))) {
    if (!any(boxed)) return;
    const Whole all(VoxelBox::kParts);
    for (int axis = 0; axis < 3; ++axis) {
      const Whole a = shiftedRight<3>(code) & Whole(3), b = code & Whole(7);
      const Mask plain = a < b;
      lower[axis] = toReal(choose(plain, a, all - a)) * Real(1.0f / VoxelBox::kParts);
      upper[axis] = toReal(choose(plain, b, all - b)) * Real(1.0f / VoxelBox::kParts);
      code = shiftedRight<VoxelBox::kAxisBits>(code);
    }
  }
  /// How many times as dense the fibres are there as spread over the voxel: VoxelBox::crowding(). Only where any ray's
  /// is boxed.
  HWY_INLINE Real crowding() const {
    const Real volume = (upper[0] - lower[0]) * (upper[1] - lower[1]) * (upper[2] - lower[2]);
    return Real(1.0f) / choose(boxed, volume, Real(1.0f));
  }
  /// The same at a place in the voxel, in widths of it: 0 outside of the box.
  HWY_INLINE Real crowdingAt(const Vector& place) const {
    if (!any(boxed)) return Real(1.0f);
    const Mask inside = (lower[0] <= place.x) & (place.x < upper[0]) & (lower[1] <= place.y) & (place.y < upper[1]) &
                        (lower[2] <= place.z) & (place.z < upper[2]);
    return orZero(inside | ~boxed, crowding());
  }
};

/// As the cloth lies in the world; `frame` has its columns.
HWY_INLINE FibreLanes inWorld(const FibreLanes& fibres, const Vector (&frame)[3], Real densityScale) {
  const Vector bent = frame[0] * fibres.direction.x + frame[1] * fibres.direction.y + frame[2] * fibres.direction.z;
  const Real stretch = squareRoot(dot(bent, bent));
  return {bent * (Real(1.0f) / stretch), fibres.spread, fibres.lengthDensity * (stretch * densityScale), fibres.box};
}

/// Of two neighbours of the table, in units of it.
HWY_INLINE Real between(Whole pair, Real fraction) {
  const Real lower = toReal(pair & Whole(0xFFFF)), upper = toReal(shiftedRight<16>(pair));
  return lower + fraction * (upper - lower);
}

/// I(alpha, s): TangentSpread::projectedLengthOfSquare().
HWY_INLINE Real projectedLength(const SpreadPairs& table, Real sinSquare, Real spread) {
  const Real k = Real(2.0f) * spread * spread, sum = sinSquare + k;
  const Mask some = Real(0.0f) < sum;
  const Real x =
      sinSquare * (Real(1.0f) + k) / choose(some, sum, Real(1.0f)) * Real(static_cast<float>(table.ratios - 1));
  const Real y = spread * Real(static_cast<float>(table.spreads - 1));
  // Lanes without a ray may hold anything, and must read from the table all the same.
  const Whole i = most(Whole(0), least(toWhole(x), Whole(table.ratios - 2)));
  const Whole j = most(Whole(0), least(toWhole(y), Whole(table.spreads - 2)));
  const Real fx = x - toReal(i), fy = y - toReal(j);
  const Whole at = j * Whole(table.ratios) + i;
  const Whole low = gather(table.pairs.data(), at), high = gather(table.pairs.data() + table.ratios, at);
  const Real a = between(low, fx), b = between(high, fx);
  return orZero(some, least(Real(1.0f), squareRoot(sum) * (a + fy * (b - a)) * Real(SpreadPairs::kUnit)));
}

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
