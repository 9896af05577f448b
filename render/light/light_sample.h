#pragma once

#include "core/base/units.h"

namespace loomlight {

/// A direction from which light may arrive at a point, chosen by Lighting::sample. An unbiased estimate of the light
/// scattered is f(wi) * Lighting::radiance(sample) / pdf. How bright it is there is told apart, because most that look
/// for a lamp have no use for it.
struct LightSample {
  glm::vec3 wi{0, 0, 1};  ///< unit, towards the light
  float distance = 0;     ///< mm; infinity for everything but point lights
  float pdf = 0;          ///< > 0; per solid angle, of the mixture of all lights of some size: Lighting::pdf(wi); delta
                          ///< lights: the probability of choosing this one
  float irradiance = 0;   ///< of delta lights, which can only be found by sampling them: across wi; of others 0
  bool isDelta() const { return irradiance > 0; }
};

}  // namespace loomlight
