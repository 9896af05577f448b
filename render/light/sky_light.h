#pragma once

#include <optional>

#include "core/base/random.h"
#include "core/fabric/model/fabric.h"
#include "render/light/daylight.h"
#include "render/light/light_sample.h"
#include "render/light/sphere_table.h"

namespace loomlight {

/// Sky, ground and sun. The sun is sampled as a cone, the rest by a table of its luminance; which of both, by power.
class SkyLight {
 public:
  explicit SkyLight(const Light& light);

  Rgb escape(glm::vec3 d) const;
  bool wantsSampling() const { return true; }
  std::optional<LightSample> sample(glm::vec3 p, Random& random) const;
  float pdf(glm::vec3 d) const;

 private:
  bool inSun(glm::vec3 d) const;
  float mixture(float tablePdf, bool inSun) const;
  /// A point of the disc: the first is the share of its area that lies further in, the second how far about its centre.
  glm::vec3 sunPoint(Random::Pair u) const;

  Daylight daylight_;
  float intensity_;
  SphereTable table_;
  float sunChance_ = 0;
  glm::vec3 sunX_{0}, sunY_{0};  ///< complete the sun's direction to a frame
};

}  // namespace loomlight
