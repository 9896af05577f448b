#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "core/base/simd.h"

namespace loomlight::optics {

// Elementary functions. T is the number of one ray, or of several side by side.

/// One of each mode of a fibre: R, TT, TRT, residual.
template <class T>
using ModesOf = std::array<T, 4>;

/// Of each ray that of its own mode; U is T, or float where it is the same for all.
template <class T, class U>
T chosen(WholeOf<T> mode, const ModesOf<U>& of) {
  return mode == 0 ? of[0] - T{} : mode == 1 ? of[1] - T{} : mode == 2 ? of[2] - T{} : of[3] - T{};
}

/// Clamped to [-1, 1]; not-a-number becomes 1, so that bad directions cannot leave a table.
template <class T>
T withinOne(T x) {
  const T one = broadcast<T>(1.0);
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

/// Without what follows the point; of floats of at most 2^31.
template <class T>
T towardsZero(T x) {
  return toFloats<T>(truncated(x));
}

/// 2^n for a whole n in [-126, 127]: the lowest bits of a float of 2^23 and more are a whole number, here the exponent.
template <class T>
T powerOfTwo(T n) {
  return std::bit_cast<T>(std::bit_cast<WholeOf<T>>(n + (0x1p23f + 127)) << 23);
}

#include "render/optics/exponential-inl.h"

/// |atan2(sine, cosine)|, in [0, pi]; absolute error below 6e-7. The pair need not be normalised; (0, 0) gives 0.
template <class T>
T angle(T sine, T cosine) {
  const T s = magnitude(sine), c = magnitude(cosine);
  const T ratio = least(s, c) / most(most(s, c), broadcast<T>(1e-30f));
  T a = ratio * polynomial(ratio * ratio, 0.999999882f, -0.333318127f, 0.199669618f, -0.140032902f, 0.0986886546f,
                           -0.0588297531f, 0.0237805186f, -0.00455979199f);
  a = s > c ? 1.57079633f - a : a;
  return cosine < 0 ? 3.14159265f - a : a;
}

template <class T>
struct SinCos {
  T sine, cosine;
};

/// Of pi * y, y in [-1, 1]; absolute error below 6e-7.
template <class T>
SinCos<T> sinCosPi(T y) {
  const T t = y * y;
  return {y * polynomial(t, 3.14159265f, -5.16771255f, 2.55016034f, -0.599242231f, 0.0820817412f, -0.00727518478f,
                         0.000395236827f),
          polynomial(t, 0.999999989f, -4.93480112f, 4.05869475f, -1.33515802f, 0.235029023f, -0.0253582858f,
                     0.00159367821f)};
}

/// ln x for 0 <= x < infinity; absolute error below 2e-7, relative below 1e-6 around 1; zero counts as 1e-38.
template <class T>
T logarithm(T x) {
  const auto bits = std::bit_cast<WholeOf<T>>(x);
  const WholeOf<T> exponent = (bits - 0x3f3504f3) >> 23;  // such that the rest is in [1, 2) / sqrt(2)
  const T rest = std::bit_cast<T>(bits - (exponent << 23));
  const T z = (rest - 1) / (rest + 1);  // ln = 2 artanh z
  return toFloats<T>(exponent) * 0.693147181f +
         z * polynomial(z * z, 2.0f, 0.666666667f, 0.4f, 0.285714286f, 0.222222222f);
}

/// The modified Bessel function as I0(x) e^-x = factor * e^-rest: the rest is x where x is small, and 0 where it is
/// large. Takes the square root of x >= 0. Relative error of the factor below 5e-7 (Abramowitz & Stegun 9.8.1, 9.8.2).
template <class T>
struct BesselI0 {
  T factor, rest;
};

template <class T>
BesselI0<T> besselI0(T root) {
  constexpr float edge = 3.75f;
  const T x = root * root;
  const T low = x * x / (edge * edge);
  const T inverse = 1 / most(root, broadcast<T>(1.0f));
  const T high = edge * inverse * inverse;
  const T series = polynomial(low, 1.0f, 3.5156229f, 3.0899424f, 1.2067492f, 0.2659732f, 0.0360768f, 0.0045813f);
  const T asymptotic = inverse * polynomial(high, 0.39894228f, 0.01328592f, 0.00225319f, -0.00157565f, 0.00916281f,
                                            -0.02057706f, 0.02635537f, -0.01647633f, 0.00392377f);
  const auto small = x < edge;
  return {small ? series : asymptotic, small ? x : T{}};
}

}  // namespace loomlight::optics
