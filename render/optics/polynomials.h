#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "core/base/simd.h"

namespace loomlight::optics {

// Elementary functions for the four modes of a fibre side by side: R, TT, TRT, residual.

/// Clamped to [-1, 1]; not-a-number becomes 1, so that bad directions cannot leave a table.
inline float withinOne(float x) {
  return std::max(-1.0f, std::min(1.0f, x));
}
inline Float32x4 withinOne(Float32x4 x) {
  const Float32x4 one = broadcast<Float32x4>(1.0f);
  return most(-one, least(x, one));
}
/// c0 + c1 x + c2 x^2 + ..., by pairs (Estrin), so that few operations wait for another: the latency of these chains is
/// what a path waits for. The polynomials below are Chebyshev interpolants of the functions named.
template <class T, size_t N>
T polynomial(T x, const std::array<T, N>& c) {
  if constexpr (N == 1) {
    return c[0];
  } else {
    std::array<T, (N + 1) / 2> pairs;
    for (size_t i = 0; i < N / 2; ++i) pairs[i] = c[2 * i] + x * c[2 * i + 1];
    if constexpr (N % 2 == 1) pairs[N / 2] = c[N - 1];
    return polynomial(x * x, pairs);
  }
}
template <class T, class... C>
T polynomial(T x, C... c) {
  return polynomial(x, std::array<T, sizeof...(C)>{(T{} + c)...});
}

/// e^x for x <= 0, relative error below 5e-6 (2e-7 for x > -1). Never below e^-40, which keeps products of two normal.
inline Float32x4 exponential(Float32x4 x) {
  const Float32x4 t = most(x, broadcast<Float32x4>(-40.0f)) * 1.44269504f;
  const Int32x4 whole = __builtin_convertvector(t, Int32x4);  // towards zero, so that the rest is in (-1, 0]
  const Float32x4 power = polynomial(t - __builtin_convertvector(whole, Float32x4), 1.0f, 0.6931470452f, 0.2402243312f,
                                     0.05549093212f, 0.009579859973f, 0.001275540135f, 0.0001093289239f);
  return power * reinterpret_cast<Float32x4>((whole + 127) << 23);
}

/// |atan2(sine, cosine)|, in [0, pi]; absolute error below 6e-7. The pair need not be normalised; (0, 0) gives 0.
inline Float32x4 angle(Float32x4 sine, Float32x4 cosine) {
  const Float32x4 s = magnitude(sine), c = magnitude(cosine);
  const Float32x4 ratio = least(s, c) / most(most(s, c), broadcast<Float32x4>(1e-30f));
  Float32x4 a = ratio * polynomial(ratio * ratio, 0.999999882f, -0.333318127f, 0.199669618f, -0.140032902f,
                                   0.0986886546f, -0.0588297531f, 0.0237805186f, -0.00455979199f);
  a = s > c ? 1.57079633f - a : a;
  return cosine < 0 ? 3.14159265f - a : a;
}

struct SinCos {
  float sine, cosine;
};

/// Of pi * y, y in [-1, 1]; absolute error below 6e-7.
inline SinCos sinCosPi(float y) {
  const float t = y * y;
  return {y * polynomial(t, 3.14159265f, -5.16771255f, 2.55016034f, -0.599242231f, 0.0820817412f, -0.00727518478f,
                         0.000395236827f),
          polynomial(t, 0.999999989f, -4.93480112f, 4.05869475f, -1.33515802f, 0.235029023f, -0.0253582858f,
                     0.00159367821f)};
}

/// ln x for 0 <= x < infinity; absolute error below 2e-7, relative below 1e-6 around 1; zero counts as 1e-38. Inline:
/// a call would spill every vector register.
inline float logarithm(float x) {
  const int bits = std::bit_cast<int>(x);
  const int exponent = (bits - 0x3f3504f3) >> 23;  // such that the rest is in [1, 2) / sqrt(2)
  const float rest = std::bit_cast<float>(bits - (exponent << 23));
  const float z = (rest - 1) / (rest + 1);  // ln = 2 artanh z
  return static_cast<float>(exponent) * 0.693147181f +
         z * polynomial(z * z, 2.0f, 0.666666667f, 0.4f, 0.285714286f, 0.222222222f);
}

/// The modified Bessel function as I0(x) e^-x = factor * e^-rest: the rest is x where x is small, and 0 where it is
/// large. Takes the square root of x >= 0. Relative error of the factor below 5e-7 (Abramowitz & Stegun 9.8.1, 9.8.2).
struct BesselI0 {
  Float32x4 factor, rest;
};

inline BesselI0 besselI0(Float32x4 root) {
  constexpr float edge = 3.75f;
  const Float32x4 x = root * root;
  const Float32x4 low = x * x / (edge * edge);
  const Float32x4 inverse = 1 / most(root, broadcast<Float32x4>(1.0f));
  const Float32x4 high = edge * inverse * inverse;
  const Float32x4 series =
      polynomial(low, 1.0f, 3.5156229f, 3.0899424f, 1.2067492f, 0.2659732f, 0.0360768f, 0.0045813f);
  const Float32x4 asymptotic = inverse * polynomial(high, 0.39894228f, 0.01328592f, 0.00225319f, -0.00157565f,
                                                    0.00916281f, -0.02057706f, 0.02635537f, -0.01647633f, 0.00392377f);
  const Int32x4 small = x < edge;
  return {small ? series : asymptotic, small ? x : Float32x4{}};
}

}  // namespace loomlight::optics
