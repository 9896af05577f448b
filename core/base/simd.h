#pragma once

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

/// The same number in all four lanes.
template <class Vector>
Vector broadcast(double x) {
  static_assert(kLanes<Vector> == 4);
  using Number = std::remove_cvref_t<decltype(Vector{}[0])>;
  const auto number = static_cast<Number>(x);
  return Vector{number, number, number, number};
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
inline float squareRoot(float a) {
  return std::sqrt(a);
}
inline Float32x4 squareRoot(Float32x4 a) {
  return Float32x4{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
inline Float64x4 squareRoot(Float64x4 a) {
  return Float64x4{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
inline float sum(Float32x4 a) {
  return (a[0] + a[1]) + (a[2] + a[3]);
}
inline bool any(Int64x4 mask) {
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}
/// Towards zero.
inline Int32x4 truncated(Float64x4 a) {
  return __builtin_convertvector(a, Int32x4);
}
/// Rounded to floats, side by side.
inline Float32x8 joined(Float64x4 a, Float64x4 b) {
  return __builtin_shufflevector(__builtin_convertvector(a, Float32x4), __builtin_convertvector(b, Float32x4), 0, 1, 2,
                                 3, 4, 5, 6, 7);
}

}  // namespace loomlight
