#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "render/optics/polynomials.h"

namespace loomlight::optics {

/// What a smooth, clear cylinder does to rays of one direction that meet it at offsets h: how the light divides among
/// the modes, where each would leave, and how far it travels inside. With the Bravais index this is a circle in the
/// plane across the fibre (Marschner et al. 2003). T is one offset, or several side by side.
template <class T>
struct CylinderHit {
  float sineO, cosineO;    ///< inclination of wo to the plane across the fibre
  glm::vec2 azimuthO;      ///< unit; wo in that plane
  std::array<T, 4> share;  ///< probability of R, TT, TRT, residual; sums to one
  T inside;                ///< internal reflectance f
  T chord;                 ///< length of one internal traverse, in radii
  /// Unit complex numbers e^(-i Phi_p), Phi_p = 2 p gamma_t - 2 gamma_o + p pi: the turn in azimuth of each mode.
  std::array<T, 4> turnCosine, turnSine;

  CylinderHit(glm::vec3 wo, T h, float index);
};

/// One number of each mode as a vector.
inline Float32x4 sideBySide(const std::array<float, 4>& modes) {
  return Float32x4{modes[0], modes[1], modes[2], modes[3]};
}

/// Reflectance for unpolarised light, from the cosine outside and index times the cosine inside (Fresnel).
template <class T>
inline T fresnel(T cosine, T refracted, float index) {
  const T s = cosine - refracted, s2 = cosine + refracted;
  const T p = index * index * cosine - refracted, p2 = index * index * cosine + refracted;
  const T a = s * p2, b = p * s2, c = s2 * p2;
  return 0.5f * (a * a + b * b) / (c * c);
}

template <class T>
inline CylinderHit<T>::CylinderHit(glm::vec3 wo, T h, float index) {
  sineO = withinOne(wo.x);
  const float cosine2 = std::min(1.0f, wo.y * wo.y + wo.z * wo.z);
  h = withinOne(h);
  // k = eta cos theta_t and e = eta cos theta_t cos gamma_t: every angle inside follows from these two roots.
  const float k2 = index * index - 1 + cosine2;
  cosineO = std::sqrt(cosine2);
  const float k = std::sqrt(k2);
  const T e = squareRoot(k2 - h * h * cosine2);
  const T cosGammaO = squareRoot(1 - h * h);
  azimuthO = cosineO > 0 ? glm::vec2(wo.y, wo.z) * (1 / cosineO) : glm::vec2(1, 0);
  const float inverse = 1 / k;
  const T cosGammaT = e * inverse, sinGammaT = h * cosineO * inverse;
  chord = 2 * cosGammaT * index * inverse;

  const T f = fresnel<T>(cosineO * cosGammaO, e, index);
  const T entering = (1 - f) * (1 - f);
  inside = f;
  share = {f, entering, entering * f, (1 - f) * f * f};

  // First e^(2 i gamma_o), then per traverse once more -e^(-2 i gamma_t).
  const T c0 = 1 - 2 * h * h, s0 = 2 * h * cosGammaO;
  const T ct = 2 * sinGammaT * sinGammaT - 1, st = 2 * sinGammaT * cosGammaT;
  const T c1 = c0 * ct - s0 * st, s1 = c0 * st + s0 * ct;
  const T c2 = c1 * ct - s1 * st, s2 = c1 * st + s1 * ct;
  turnCosine = {c0, c1, c2, T{} + 1};
  turnSine = {s0, s1, s2, T{}};
}

}  // namespace loomlight::optics
