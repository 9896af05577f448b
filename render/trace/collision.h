#pragma once

#include <optional>

#include "core/base/random.h"
#include "render/trace/cloth_walk.h"
#include "render/trace/volume_tracer.h"

namespace loomlight {

/// A virtual scattering event (section 8.1 of the report): where a ray met a fibre, and which.
struct Collision {
  Place place;
  float distance_mm = 0;   ///< along the ray
  glm::vec3 tangent{1, 0, 0};
  glm::vec3 normal{0, 0, 1};  ///< of the cloth's face
  YarnOptics optics;
  int yarn = 0;            ///< index into Fabric::yarns
  int end = 0, pick = 0;   ///< the crossing cell
};

/// The first fibre along a ray, drawn from the exact exponential free flight through the summed extinction of every
/// voxel; nullopt when the ray leaves the scene. The component is chosen in proportion to its own extinction and the
/// tangent weighted by the sine (EventLaw::projected): the law of the fibre that a random ray hits.
std::optional<Collision> sampleCollision(const Scene& scene, const Place& from, glm::vec3 direction, Random& random,
                                         TraceCounts& counts);

/// The probability that a ray meets no fibre within `distance`: exact down to e^-4, below that an unbiased estimate
/// (0 or e^-4), because what hardly gets through is not worth walking for.
float transmittance(const Scene& scene, const Place& from, glm::vec3 direction, float distance, Random& random,
                    TraceCounts& counts);

}  // namespace loomlight
