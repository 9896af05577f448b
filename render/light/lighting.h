#pragma once

#include <memory>
#include <vector>

#include "core/base/random.h"
#include "core/fabric/fabric.h"

namespace loomlight {

struct Image;

/// Light arriving at a point from one direction, chosen by Lighting::sample.
struct LightSample {
  glm::vec3 wi{0, 0, 1};      ///< unit, towards the light
  float distance = 0;         ///< mm; infinity for everything but point lights
  Rgb radiance{0};            ///< already divided by nothing: for delta lights, the irradiance perpendicular to wi
  float pdf = 0;              ///< per solid angle, times the probability of choosing this light; delta lights: that
                              ///< probability alone
  bool delta = false;         ///< wi can only be found by sampling the light
};

/// All the light of a scene, from far away or from the headlight. Immutable.
class Lighting {
 public:
  /// Loads or computes the environment. `eye_mm` is where the headlight shines from. Throws InputError for a bad file.
  Lighting(const Light& light, glm::vec3 eye_mm);

  /// Radiance that a ray leaving the scene in direction `d` meets. Delta lights are not in it.
  Rgb escape(glm::vec3 d) const;
  /// Whether sampling lights is worth its shadow rays; false for the white dome, which BCSDF sampling finds as well.
  bool wantsSampling() const;
  /// One light, one direction; nullopt when nothing can arrive at p.
  std::optional<LightSample> sample(glm::vec3 p, Random& random) const;
  /// The pdf with which sample() chooses the non-delta direction d.
  float pdf(glm::vec3 d) const;
};

}  // namespace loomlight
