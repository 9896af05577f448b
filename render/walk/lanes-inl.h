// Numbers of several rays side by side, one in each lane of a register, with the operators of plain numbers: Highway's
// vectors for the instruction set that this is compiled for. It is compiled once for each of them (Highway's
// foreach_target.h), so it has a guard of its own kind. Every operation rounds as the same one on plain numbers does.
#if defined(LOOMLIGHT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LOOMLIGHT_LANES_INL_H_
#undef LOOMLIGHT_LANES_INL_H_
#else
#define LOOMLIGHT_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include "render/walk/walk_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace loomlight::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using RealTag = hn::CappedTag<float, kWalkLanes>;
using WholeTag = hn::RebindToSigned<RealTag>;
using BitsTag = hn::RebindToUnsigned<RealTag>;

/// Which lanes something holds for.
struct Mask {
  hn::Mask<RealTag> in;
  HWY_INLINE Mask() {}  // not set, as a vector is not
  HWY_INLINE Mask(hn::Mask<RealTag> m) : in(m) {}
};
HWY_INLINE Mask operator&(Mask a, Mask b) {
  return {hn::And(a.in, b.in)};
}
HWY_INLINE Mask operator|(Mask a, Mask b) {
  return {hn::Or(a.in, b.in)};
}
HWY_INLINE Mask operator~(Mask a) {
  return {hn::Not(a.in)};
}
HWY_INLINE bool any(Mask a) {
  return !hn::AllFalse(RealTag(), a.in);
}

/// 32 bits with sign.
struct Whole {
  hn::Vec<WholeTag> in;
  Whole() = default;
  HWY_INLINE Whole(hn::Vec<WholeTag> v) : in(v) {}
  HWY_INLINE Whole(int32_t all) : in(hn::Set(WholeTag(), all)) {}
  HWY_INLINE static Whole of(const int32_t* lanes) { return hn::Load(WholeTag(), lanes); }
  HWY_INLINE void to(int32_t* lanes) const { hn::Store(in, WholeTag(), lanes); }
};
HWY_INLINE Mask maskOf(hn::Mask<WholeTag> mask) {
  return {hn::RebindMask(RealTag(), mask)};
}
HWY_INLINE hn::Mask<WholeTag> wholeMask(Mask mask) {
  return hn::RebindMask(WholeTag(), mask.in);
}
HWY_INLINE Whole operator+(Whole a, Whole b) {
  return hn::Add(a.in, b.in);
}
HWY_INLINE Whole operator-(Whole a, Whole b) {
  return hn::Sub(a.in, b.in);
}
HWY_INLINE Whole operator*(Whole a, Whole b) {
  return hn::Mul(a.in, b.in);
}
HWY_INLINE Whole operator&(Whole a, Whole b) {
  return hn::And(a.in, b.in);
}
HWY_INLINE Whole operator|(Whole a, Whole b) {
  return hn::Or(a.in, b.in);
}
HWY_INLINE Mask operator==(Whole a, Whole b) {
  return maskOf(hn::Eq(a.in, b.in));
}
HWY_INLINE Mask operator<(Whole a, Whole b) {
  return maskOf(hn::Lt(a.in, b.in));
}
HWY_INLINE Whole least(Whole a, Whole b) {
  return hn::Min(a.in, b.in);
}
HWY_INLINE Whole most(Whole a, Whole b) {
  return hn::Max(a.in, b.in);
}
HWY_INLINE Whole choose(Mask mask, Whole yes, Whole no) {
  return hn::IfThenElse(wholeMask(mask), yes.in, no.in);
}
template <int kBits>
HWY_INLINE Whole shiftedLeft(Whole a) {
  return hn::ShiftLeft<kBits>(a.in);
}
/// Zeros come in from above.
template <int kBits>
HWY_INLINE Whole shiftedRight(Whole a) {
  return hn::BitCast(WholeTag(), hn::ShiftRight<kBits>(hn::BitCast(BitsTag(), a.in)));
}
/// The sign comes in from above.
template <int kBits>
HWY_INLINE Whole shiftedRightSigned(Whole a) {
  return hn::ShiftRight<kBits>(a.in);
}
/// 1 << bit, 0 <= bit < 32.
HWY_INLINE Whole bitNumber(Whole bit) {
  return hn::BitCast(WholeTag(), hn::Shl(hn::Set(BitsTag(), 1u), hn::BitCast(BitsTag(), bit.in)));
}
HWY_INLINE Whole setBits(Whole a) {
  return hn::BitCast(WholeTag(), hn::PopulationCount(hn::BitCast(BitsTag(), a.in)));
}
/// 32 bits from so many bytes beyond `base`, counted without a sign: up to 4 GiB.
HWY_INLINE Whole gatherBytes(const void* base, Whole byte) {
  constexpr int64_t kMiddle = int64_t{1} << 31;  // offsets have a sign, so they are counted from there
  const auto* middle = reinterpret_cast<const int32_t*>(static_cast<const char*>(base) + kMiddle);
  return hn::GatherOffset(WholeTag(), middle, hn::Add(byte.in, hn::Set(WholeTag(), static_cast<int32_t>(-kMiddle))));
}

HWY_INLINE Whole gather(const int32_t* base, Whole index) {
  return hn::GatherIndex(WholeTag(), base, index.in);
}

struct Real {
  hn::Vec<RealTag> in;
  Real() = default;
  HWY_INLINE Real(hn::Vec<RealTag> v) : in(v) {}
  HWY_INLINE Real(float all) : in(hn::Set(RealTag(), all)) {}
  HWY_INLINE static Real of(const float* lanes) { return hn::Load(RealTag(), lanes); }
  HWY_INLINE void to(float* lanes) const { hn::Store(in, RealTag(), lanes); }
};
HWY_INLINE Real operator+(Real a, Real b) {
  return hn::Add(a.in, b.in);
}
HWY_INLINE Real operator-(Real a, Real b) {
  return hn::Sub(a.in, b.in);
}
HWY_INLINE Real operator-(Real a) {
  return hn::Neg(a.in);
}
HWY_INLINE Real operator*(Real a, Real b) {
  return hn::Mul(a.in, b.in);
}
HWY_INLINE Real operator/(Real a, Real b) {
  return hn::Div(a.in, b.in);
}
HWY_INLINE Mask operator<(Real a, Real b) {
  return {hn::Lt(a.in, b.in)};
}
HWY_INLINE Mask operator<=(Real a, Real b) {
  return {hn::Le(a.in, b.in)};
}
HWY_INLINE Real least(Real a, Real b) {
  return hn::Min(a.in, b.in);
}
HWY_INLINE Real most(Real a, Real b) {
  return hn::Max(a.in, b.in);
}
HWY_INLINE Real squareRoot(Real a) {
  return hn::Sqrt(a.in);
}
HWY_INLINE Real magnitude(Real a) {
  return hn::Abs(a.in);
}
HWY_INLINE Real choose(Mask mask, Real yes, Real no) {
  return hn::IfThenElse(mask.in, yes.in, no.in);
}
HWY_INLINE Real orZero(Mask mask, Real yes) {
  return hn::IfThenElseZero(mask.in, yes.in);
}
HWY_INLINE Real toReal(Whole a) {
  return hn::ConvertTo(RealTag(), a.in);
}
/// Towards zero.
HWY_INLINE Whole toWhole(Real a) {
  return hn::ConvertTo(WholeTag(), a.in);
}
HWY_INLINE Real realOfBits(Whole bits) {
  return hn::BitCast(RealTag(), bits.in);
}

/// The same number in all lanes.
template <class T>
HWY_INLINE T broadcast(float x) {
  return T(x);
}
/// Without what follows the point.
HWY_INLINE Real towardsZero(Real a) {
  return hn::Trunc(a.in);
}
/// 2^n for a whole n in [-126, 127]: the lowest bits of a float of 2^23 and more are a whole number, here its exponent.
HWY_INLINE Real powerOfTwo(Real n) {
  return realOfBits(shiftedLeft<23>(hn::BitCast(WholeTag(), (n + Real(0x1p23f + 127)).in)));
}

struct Vector {
  Real x, y, z;
};
/// Columns x, y, z; the lanes from `lane` on.
HWY_INLINE Vector vectorOf(const LaneFloats (&columns)[3], size_t lane) {
  return {Real::of(&columns[0][lane]), Real::of(&columns[1][lane]), Real::of(&columns[2][lane])};
}
HWY_INLINE Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Vector operator*(const Vector& a, Real s) {
  return {a.x * s, a.y * s, a.z * s};
}
HWY_INLINE Real dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace loomlight::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
