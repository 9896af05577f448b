// What rays meet of the fibres of a voxel, side by side: Component::decode(), inWorld(), extinction(), knownAbsent()
// and FibreInVoxels in lanes. Compiled once for each instruction set, as lanes-inl.h is.
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

/// A flight of before, seen from the middle of the voxel that the ray is in (RaySegment, knownAbsent()).
struct PastSegmentLanes {
  Vector direction;
  Vector offset;  ///< from its end to that middle
  Real along;     ///< of the offset, along the flight
  Real apart;     ///< length of the offset across the flight
  Real length;
  Mask there;

  HWY_INLINE PastSegmentLanes(const WalkLanes::PastSegment& past, size_t lane, const Vector& onRay) {
    direction = vectorOf(past.direction, lane);
    offset = vectorOf(past.offset_mm, lane) + onRay;
    length = Real::of(&past.length_mm[lane]);
    along = dot(offset, direction);
    const Vector across = offset - direction * along;
    apart = squareRoot(dot(across, across));
    there = Real(0.0f) < length;
  }

  /// The share of such fibres that would have blocked the flight.
  HWY_INLINE Real absent(const FibreLanes& fibres, Real radius) const {
    const Real alongTangent = dot(direction, fibres.direction);
    const Real lineSquare = Real(1.0f) - alongTangent * alongTangent;
    const Real back = alongTangent * dot(offset, fibres.direction) - along;
    const Mask beside = there & (Real(1e-6f) <= lineSquare) & (Real(0.0f) < back) & (back < length * lineSquare);
    const Vector normal = cross(fibres.direction, direction);
    const Real line = squareRoot(choose(beside, lineSquare, Real(1.0f)));
    const Real distance = magnitude(dot(offset, normal)) / line + fibres.spread * apart;
    return orZero(beside, most(Real(0.0f), Real(1.0f) - distance / (Real(2.0f) * radius)));
  }
};

/// FibreInVoxels::lengthDensity() of the fibre that each ray came from, in the voxel with that lower corner.
HWY_INLINE Real lengthDensityOf(const WalkLanes::Before& before, size_t lane, const Vector& lower, const Vector& size) {
  const Vector axis = vectorOf(before.axis_mm, lane), tangent = vectorOf(before.tangent, lane);
  const Real radius = Real::of(&before.radius_mm[lane]);
  const Vector to = lower + size * Real(0.5f) - axis;
  const Real along = dot(to, tangent), reach = Real(0.5f) * squareRoot(dot(size, size)) + radius;
  const Mask near = dot(to, to) - along * along <= reach * reach;
  const Real r = Real(0.5f) * radius;
  // In the plane of a face nothing is divided by nothing: a fibre along an axis is tilted by less than a rounding.
  const Real tiny(1e-18f);
  const Vector inverse{Real(1.0f) / choose(magnitude(tangent.x) < tiny, tiny, tangent.x),
                       Real(1.0f) / choose(magnitude(tangent.y) < tiny, tiny, tangent.y),
                       Real(1.0f) / choose(magnitude(tangent.z) < tiny, tiny, tangent.z)};
  Real length(0.0f);
  for (int corner = 0; corner < 4; ++corner) {
    const Real x = corner < 2 ? r : -r, y = corner % 2 == 0 ? r : -r, z = corner == 0 || corner == 3 ? r : -r;
    const Vector from = lower - axis - Vector{x, y, z};
    const Vector a{from.x * inverse.x, from.y * inverse.y, from.z * inverse.z};
    const Vector b = a + Vector{size.x * inverse.x, size.y * inverse.y, size.z * inverse.z};
    const Real enter = most(most(least(a.x, b.x), least(a.y, b.y)), least(a.z, b.z));
    const Real leave = least(least(most(a.x, b.x), most(a.y, b.y)), most(a.z, b.z));
    length = length + most(Real(0.0f), leave - enter);
  }
  return orZero(near, Real(0.25f) * length / (size.x * size.y * size.z));
}

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
