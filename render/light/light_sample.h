#pragma once

#include "core/base/units.h"

namespace loomlight {

/// Light arriving at a point from one direction, chosen by Lighting::sample. For a light of some size, an unbiased
/// estimate of the light scattered is f(wi) * radiance / pdf; for a delta light, f(wi) * radiance / pdf too, only that
/// radiance is an irradiance and pdf a probability.
struct LightSample {
  glm::vec3 wi{0, 0, 1};  ///< unit, towards the light
  float distance = 0;     ///< mm; infinity for everything but point lights
  Rgb radiance{0};        ///< of all lights of some size in direction wi; delta lights: irradiance perpendicular to wi
  float pdf = 0;          ///< > 0; per solid angle, of the mixture of all lights of some size: Lighting::pdf(wi); delta
                          ///< lights: the probability of choosing this one
  bool delta = false;     ///< wi can only be found by sampling the light
};

}  // namespace loomlight
