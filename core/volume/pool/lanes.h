#pragma once

#include <cmath>
#include <cstdint>

namespace loomlight {

/// Four doubles computed side by side: four voxels of a brick. GCC and Clang map the arithmetic to one AVX register;
/// comparisons give masks for the ?: operator.
using Lanes = double __attribute__((vector_size(32)));
using LaneMask = int64_t __attribute__((vector_size(32)));
using IntLanes = int32_t __attribute__((vector_size(16)));
using FloatLanes = float __attribute__((vector_size(16)));
inline constexpr int kLanes = 4;
/// Eight floats, where float is enough.
using WideFloats = float __attribute__((vector_size(32)));
using WideInts = int32_t __attribute__((vector_size(32)));
inline constexpr int kWide = 8;

inline Lanes inAllLanes(double x) {
  return Lanes{x, x, x, x};
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
inline Lanes squareRoot(Lanes a) {
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
inline bool any(LaneMask mask) {
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}
/// Towards zero.
inline IntLanes truncated(Lanes a) {
  return __builtin_convertvector(a, IntLanes);
}
inline Lanes toLanes(IntLanes a) {
  return __builtin_convertvector(a, Lanes);
}
/// Rounded to floats, side by side.
inline WideFloats joined(Lanes a, Lanes b) {
  return __builtin_shufflevector(__builtin_convertvector(a, FloatLanes), __builtin_convertvector(b, FloatLanes), 0, 1,
                                 2, 3, 4, 5, 6, 7);
}

}  // namespace loomlight
