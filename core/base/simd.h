#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace loomlight {

// Numbers computed side by side. GCC and Clang map the arithmetic to SIMD registers where the machine has them, and to
// as many narrower ones where it has not: the results are the same. Comparisons give masks for the ?: operator.
using Float32x4 = float __attribute__((vector_size(16)));
using Float32x8 = float __attribute__((vector_size(32)));
using Float64x4 = double __attribute__((vector_size(32)));
using Int32x4 = int32_t __attribute__((vector_size(16)));  ///< and the mask of Float32x4
using Int32x8 = int32_t __attribute__((vector_size(32)));  ///< and the mask of Float32x8
using Int64x4 = int64_t __attribute__((vector_size(32)));  ///< the mask of Float64x4

/// How many numbers a vector has.
template <class Vector>
inline constexpr int kLanes = static_cast<int>(sizeof(Vector) / sizeof(Vector{}[0]));

/// The whole numbers, and the masks, that go with so many floats: functions of a number of one path are templates, of
/// which the same lines serve many paths side by side.
template <class T>
struct LanesOf;
template <>
struct LanesOf<float> {
  using Whole = int32_t;
  using Mask = bool;
};
template <>
struct LanesOf<Float32x4> {
  using Whole = Int32x4;
  using Mask = Int32x4;
};
template <>
struct LanesOf<Float32x8> {
  using Whole = Int32x8;
  using Mask = Int32x8;
};
template <class T>
using WholeOf = typename LanesOf<T>::Whole;
template <class T>
using MaskOf = typename LanesOf<T>::Mask;

/// The same number in all lanes.
template <class T>
T broadcast(double x) {
  if constexpr (std::is_arithmetic_v<T>) {
    return static_cast<T>(x);
  } else {
    using Number = std::remove_cvref_t<decltype(T{}[0])>;
    return static_cast<Number>(x) - T{};  // x - 0 is x to the bit
  }
}
template <class Vector>
Vector least(Vector a, Vector b) {
  return a < b ? a : b;
}
template <class Vector>
Vector most(Vector a, Vector b) {
  return a > b ? a : b;
}
template <class Vector>
Vector magnitude(Vector a) {
  return most(a, -a);
}
/// 1 with the sign of a, be it that of a zero.
template <class T>
T signOf(T a) {
  constexpr int32_t kSign = INT32_MIN;
  return std::bit_cast<T>((std::bit_cast<WholeOf<T>>(a) & kSign) | std::bit_cast<int32_t>(1.0f));
}
template <class T>
T squareRoot(T a) {
  if constexpr (std::is_arithmetic_v<T>) {
    return std::sqrt(a);
  } else {
    T root{};
    for (int i = 0; i < kLanes<T>; ++i) root[i] = std::sqrt(a[i]);
    return root;
  }
}
inline float sum(Float32x4 a) {
  return (a[0] + a[1]) + (a[2] + a[3]);
}
inline bool any(bool mask) {
  return mask;
}
inline bool any(Int32x4 mask) {
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}
inline bool any(Int32x8 mask) {
  const auto pairs = std::bit_cast<Int64x4>(mask);
  return (pairs[0] | pairs[1] | pairs[2] | pairs[3]) != 0;
}
inline bool any(Int64x4 mask) {
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}
/// Towards zero.
inline Int32x4 truncated(Float64x4 a) {
  return __builtin_convertvector(a, Int32x4);
}
/// Of floats of at most 2^31.
template <class T>
WholeOf<T> truncated(T a) {
  if constexpr (std::is_same_v<T, float>)
    return static_cast<int32_t>(a);
  else
    return __builtin_convertvector(a, WholeOf<T>);
}
template <class T>
T toFloats(WholeOf<T> a) {
  if constexpr (std::is_same_v<T, float>)
    return static_cast<float>(a);
  else
    return __builtin_convertvector(a, T);
}
/// Numbers of an array, by their places in it.
inline float gathered(const float* numbers, int32_t place) {
  return numbers[place];
}
inline Float32x8 gathered(const float* numbers, Int32x8 place) {
  return Float32x8{numbers[place[0]], numbers[place[1]], numbers[place[2]], numbers[place[3]],
                   numbers[place[4]], numbers[place[5]], numbers[place[6]], numbers[place[7]]};
}
/// Rounded to floats, side by side.
inline Float32x8 joined(Float64x4 a, Float64x4 b) {
  return __builtin_shufflevector(__builtin_convertvector(a, Float32x4), __builtin_convertvector(b, Float32x4), 0, 1, 2,
                                 3, 4, 5, 6, 7);
}

/// Columns of eight rows.
inline std::array<Float32x8, 4> transposed(const std::array<Float32x4, 8>& rows) {
  const auto beside = [&](size_t a, size_t b) {
    return __builtin_shufflevector(rows[a], rows[b], 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const auto low = [](Float32x8 a, Float32x8 b) { return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13); };
  const auto high = [](Float32x8 a, Float32x8 b) { return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15); };
  const Float32x8 r0 = beside(0, 4), r1 = beside(1, 5), r2 = beside(2, 6), r3 = beside(3, 7);
  const Float32x8 a = low(r0, r2), b = low(r1, r3), c = high(r0, r2), d = high(r1, r3);
  return {low(a, b), high(a, b), low(c, d), high(c, d)};
}

/// A vector of space, of one path or of several side by side.
template <class T>
struct Vec3Of {
  T x, y, z;
};
template <class T>
Vec3Of<T> operator+(const Vec3Of<T>& a, const Vec3Of<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec3Of<T> operator-(const Vec3Of<T>& a, const Vec3Of<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec3Of<T> operator-(const Vec3Of<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
Vec3Of<T> operator*(T s, const Vec3Of<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(const Vec3Of<T>& a, const Vec3Of<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec3Of<T> cross(const Vec3Of<T>& a, const Vec3Of<T>& b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}

}  // namespace loomlight
