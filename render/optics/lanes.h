#pragma once

#include <cmath>

namespace loomlight::optics {

/// Four floats computed side by side, one for each mode of a fibre: R, TT, TRT, residual. GCC and Clang map the
/// arithmetic to one SIMD register on every machine; comparisons give masks for the ?: operator.
using Lanes = float __attribute__((vector_size(16)));
using LaneMask = int __attribute__((vector_size(16)));

inline Lanes spread(float x) {
  return Lanes{x, x, x, x};
}
inline Lanes least(Lanes a, Lanes b) {
  return a < b ? a : b;
}
inline Lanes most(Lanes a, Lanes b) {
  return a > b ? a : b;
}
inline Lanes magnitude(Lanes a) {
  return most(a, -a);
}
inline Lanes squareRoot(Lanes a) {
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
inline float sum(Lanes a) {
  return (a[0] + a[1]) + (a[2] + a[3]);
}

/// Horner's rule, constant term first. The polynomials here are Chebyshev interpolants of the functions named.
template <class T>
T polynomial(T, float c) {
  return T{} + c;
}
template <class T, class... Rest>
T polynomial(T x, float c, Rest... rest) {
  return polynomial(x, rest...) * x + c;
}

/// e^x for x <= 0, relative error below 5e-6 (2e-7 for x > -1). Never below e^-40, which keeps products of two normal.
inline Lanes exponential(Lanes x) {
  const Lanes t = most(x, spread(-40.0f)) * 1.44269504f;
  const LaneMask whole = __builtin_convertvector(t, LaneMask);  // towards zero, so that the rest is in (-1, 0]
  const Lanes power = polynomial(t - __builtin_convertvector(whole, Lanes), 1.0f, 0.6931470452f, 0.2402243312f,
                                 0.05549093212f, 0.009579859973f, 0.001275540135f, 0.0001093289239f);
  return power * reinterpret_cast<Lanes>((whole + 127) << 23);
}

/// |atan2(sine, cosine)|, in [0, pi]; absolute error below 4e-7. The pair need not be normalised, only not both zero.
inline Lanes angle(Lanes sine, Lanes cosine) {
  const Lanes s = magnitude(sine), c = magnitude(cosine);
  const Lanes ratio = least(s, c) / most(s, c);
  Lanes a = ratio * polynomial(ratio * ratio, 0.999999882f, -0.333318127f, 0.199669618f, -0.140032902f, 0.0986886546f,
                               -0.0588297531f, 0.0237805186f, -0.00455979199f);
  a = s > c ? 1.57079633f - a : a;
  return cosine < 0 ? 3.14159265f - a : a;
}

struct SinCos {
  float sine, cosine;
};

/// Of pi * y, y in [-1, 1]; absolute error below 3e-7.
inline SinCos sinCosPi(float y) {
  const float t = y * y;
  return {y * polynomial(t, 3.14159265f, -5.16771255f, 2.55016034f, -0.599242231f, 0.0820817412f, -0.00727518478f,
                         0.000395236827f),
          polynomial(t, 0.999999989f, -4.93480112f, 4.05869475f, -1.33515802f, 0.235029023f, -0.0253582858f,
                     0.00159367821f)};
}

/// The modified Bessel function I0(x), x >= 0, as factor * e^exponent: where it is large the exponent is x, where it is
/// small 0. Relative error of the factor below 5e-7 (Abramowitz & Stegun 9.8.1, 9.8.2).
struct BesselI0 {
  Lanes factor, exponent;
};

inline BesselI0 besselI0(Lanes x) {
  constexpr float edge = 3.75f;
  const Lanes low = x * x / (edge * edge);
  const Lanes high = edge / most(x, spread(edge));
  const Lanes series = polynomial(low, 1.0f, 3.5156229f, 3.0899424f, 1.2067492f, 0.2659732f, 0.0360768f, 0.0045813f);
  const Lanes asymptotic = polynomial(high, 0.39894228f, 0.01328592f, 0.00225319f, -0.00157565f, 0.00916281f,
                                      -0.02057706f, 0.02635537f, -0.01647633f, 0.00392377f) *
                           squareRoot(high) * 0.516397779f;  // 1 / sqrt(3.75)
  const LaneMask small = x < edge;
  return {small ? series : asymptotic, small ? Lanes{} : x};
}

}  // namespace loomlight::optics
