#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "render/optics/polynomials.h"

namespace loomlight::optics {

/// What a smooth, clear cylinder does to rays that meet it at offsets h: how the light divides among the modes, where
/// each would leave, and how far it travels inside. With the Bravais index this is a circle in the plane across the
/// fibre (Marschner et al. 2003). T is one ray, or several side by side.
template <class T>
struct CylinderHit {
  T sineO, cosineO;                ///< inclination of wo to the plane across the fibre
  T azimuthOCosine, azimuthOSine;  ///< wo in that plane, unit
  std::array<T, 4> share;          ///< probability of R, TT, TRT, residual; sums to one
  T internalReflectance;           ///< f
  T chord_radii;                   ///< length of one internal traverse, in radii
  /// Unit complex numbers e^(-i Phi_p), Phi_p = 2 p gamma_t - 2 gamma_o + p pi: the turn in azimuth of each mode.
  std::array<T, 4> turnCosine, turnSine;

  CylinderHit(const Vec3Of<T>& wo, T h, float index);
};

/// Reflectance for unpolarised light, from the cosine outside and index times the cosine inside (Fresnel).
template <class T>
inline T fresnel(T cosine, T refracted, float index) {
  const T s = cosine - refracted, s2 = cosine + refracted;
  const T p = index * index * cosine - refracted, p2 = index * index * cosine + refracted;
  const T a = s * p2, b = p * s2, c = s2 * p2;
  return 0.5f * (a * a + b * b) / (c * c);
}

template <class T>
inline CylinderHit<T>::CylinderHit(const Vec3Of<T>& wo, T h, float index) {
  sineO = withinOne(wo.x);
  const T cosine2 = least(wo.y * wo.y + wo.z * wo.z, broadcast<T>(1.0));
  h = withinOne(h);
  // k = eta cos theta_t and e = eta cos theta_t cos gamma_t: every angle inside follows from these two roots.
  const T k2 = index * index - 1 + cosine2;
  cosineO = squareRoot(cosine2);
  const T k = squareRoot(k2);
  const T e = squareRoot(k2 - h * h * cosine2);
  const T cosGammaO = squareRoot(1 - h * h);
  const auto hasAzimuth = cosineO > 0;
  const T stretch = 1 / cosineO;
  azimuthOCosine = hasAzimuth ? wo.y * stretch : broadcast<T>(1.0);
  azimuthOSine = hasAzimuth ? wo.z * stretch : T{};
  const T inverse = 1 / k;
  const T cosGammaT = e * inverse, sinGammaT = h * cosineO * inverse;
  chord_radii = 2 * cosGammaT * index * inverse;

  const T f = fresnel<T>(cosineO * cosGammaO, e, index);
  const T entering = (1 - f) * (1 - f);
  internalReflectance = f;
  share = {f, entering, entering * f, (1 - f) * f * f};

  // First e^(2 i gamma_o), then per traverse once more -e^(-2 i gamma_t).
  const T c0 = 1 - 2 * h * h, s0 = 2 * h * cosGammaO;
  const T ct = 2 * sinGammaT * sinGammaT - 1, st = 2 * sinGammaT * cosGammaT;
  const T c1 = c0 * ct - s0 * st, s1 = c0 * st + s0 * ct;
  const T c2 = c1 * ct - s1 * st, s2 = c1 * st + s1 * ct;
  turnCosine = {c0, c1, c2, broadcast<T>(1.0)};
  turnSine = {s0, s1, s2, T{}};
}

}  // namespace loomlight::optics
