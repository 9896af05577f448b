// What paths know of the fibres of the voxels that they come to, side by side. Compiled once for each instruction set,
// as lanes-inl.h is.
#if defined(LOOMLIGHT_KNOWN_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LOOMLIGHT_KNOWN_LANES_INL_H_
#undef LOOMLIGHT_KNOWN_LANES_INL_H_
#else
#define LOOMLIGHT_KNOWN_LANES_INL_H_
#endif

#include "render/walk/voxel_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

/// A flight of before, seen from the middle of the voxel that the ray is in. The ways light came are free of fibres, so
/// those that would have blocked them are not there.
struct PastSegmentLanes {
  Vector direction;
  Vector offset;  ///< from its end to that middle
  Real along;     ///< of the offset, along the flight
  Real apart;     ///< length of the offset across the flight
  Real length;
  Mask there;

  HWY_INLINE PastSegmentLanes(const KnownLanes::PastSegment& past, size_t lane, const Vector& onRay) {
    direction = vectorOf(past.direction, lane);
    offset = vectorOf(past.offset_mm, lane) + onRay;
    length = Real::of(&past.length_mm[lane]);
    along = dot(offset, direction);
    const Vector across = offset - direction * along;
    apart = squareRoot(dot(across, across));
    there = Real(0.0f) < length;
  }

  /// The share of such fibres, through that middle, that would have blocked the flight. Seen along them fibres are
  /// discs, and the flight is a line.
  HWY_INLINE Real absent(const FibreLanes& fibres, Real radius) const {
    const Real alongTangent = dot(direction, fibres.direction);
    const Real lineSquare = Real(1.0f) - alongTangent * alongTangent;
    const Real back = alongTangent * dot(offset, fibres.direction) - along;
    const Mask beside = there & (Real(1e-6f) <= lineSquare) & (Real(0.0f) < back) & (back < length * lineSquare);
    const Vector normal = cross(fibres.direction, direction);
    const Real line = squareRoot(choose(beside, lineSquare, Real(1.0f)));
    // Tangents that spread see the two ways apart by a little more; not where one way is the other, reversed.
    const Real distance = magnitude(dot(offset, normal)) / line + fibres.spread * apart;
    return orZero(beside, most(Real(0.0f), Real(1.0f) - distance / (Real(2.0f) * radius)));
  }
};

/// What the fibre that each ray came from adds to the length per volume of the voxel with that lower corner, 1/mm^2:
/// its length there, spread over its section.
HWY_INLINE Real lengthDensityOf(const KnownLanes::Before& before, size_t lane, const Vector& lower,
                                const Vector& size) {
  const Vector axis = vectorOf(before.axis_mm, lane), tangent = vectorOf(before.tangent, lane);
  const Real radius = Real::of(&before.radius_mm[lane]);
  const Vector to = lower + size * Real(0.5f) - axis;
  const Real along = dot(to, tangent), reach = Real(0.5f) * squareRoot(dot(size, size)) + radius;
  const Mask near = dot(to, to) - along * along <= reach * reach;
  // Lines through the corners of a tetrahedron, which has the second moment of the section, r^2 / 4, any way it lies;
  // each is cut by the faces of the voxel as Kay and Kajiya 1986 cut rays.
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

/// The voxels that several rays are in, for what their paths know of the fibres there.
struct KnownInVoxels {
  const KnownLanes& known;
  size_t lane;              ///< the first of them
  Vector onRay_mm;          ///< from where the rays are at t = 0 to the middle of their ways through the voxels
  const Whole (&voxel)[3];  ///< counted from the corners of the cells
  const Vector& size_mm;

  /// The share of such a component's extinction that counts: what the flights before, and the fibre that the last of
  /// them came from, leave of it. That fibre is met for itself, so a voxel must not count it again.
  HWY_INLINE Real shareLeft(Mask holds, const FibreLanes& fibres, const VoxelLanes::Taken& taken) const {
    Real absent(0.0f);
    for (const KnownLanes::PastSegment& past : known.pastSegments)
      absent = most(absent, PastSegmentLanes(past, lane, onRay_mm).absent(fibres, taken.radius));
    const Real left = Real(1.0f) - absent;
    const Mask own = holds & (taken.yarn == Whole::of(&known.before.yarn[lane])) &
                     (Real(0.0f) < Real::of(&known.before.radius_mm[lane])) & (Real(0.0f) < taken.packed);
    if (!any(own)) return left;
    const Vector lower{toReal(voxel[0]) * size_mm.x, toReal(voxel[1]) * size_mm.y, toReal(voxel[2]) * size_mm.z};
    const Real before = lengthDensityOf(known.before, lane, lower, size_mm);
    const Real density = choose(own, fibres.lengthDensity, Real(1.0f));
    return choose(own, left * (Real(1.0f) - least(Real(1.0f), before / density)), left);
  }
};

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
