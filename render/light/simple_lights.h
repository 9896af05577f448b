#pragma once

#include <optional>

#include "core/base/random.h"
#include "core/fabric/model/fabric.h"
#include "render/light/light_sample.h"

namespace loomlight {

/// White of one radiance from above (dome), from below (back), or from everywhere (furnace). BCSDF sampling finds it
/// as well as light sampling would, so that shadow rays are not worth their cost.
class UniformLight {
 public:
  UniformLight(float above, float below) : above_(above), below_(below) {}

  Rgb escape(glm::vec3 d) const { return Rgb(d.z > 0 ? above_ : below_); }
  bool wantsSampling() const { return false; }
  std::optional<LightSample> sample(glm::vec3 p, Random& random) const;
  float pdf(glm::vec3 d) const;

 private:
  float chanceAbove() const { return above_ + below_ > 0 ? above_ / (above_ + below_) : 0.5f; }
  float above_, below_;
};

/// A point that shines from the eye. With intensity 1 it lights white paper that faces it, `reach_mm` away, to radiance
/// 1: its irradiance there is pi, elsewhere it falls with distance squared.
class Headlight {
 public:
  Headlight(float intensity, glm::vec3 eye_mm, float reach_mm);

  Rgb escape(glm::vec3) const { return Rgb(0); }
  bool wantsSampling() const { return true; }
  std::optional<LightSample> sample(glm::vec3 p, Random& random) const;
  float pdf(glm::vec3) const { return 0; }

 private:
  glm::vec3 position_;
  float power_;  ///< irradiance times distance squared, mm2
};

/// Parallel light. With intensity 1 it lights white paper that faces it to radiance 1: its irradiance is pi.
class DirectionalLight {
 public:
  explicit DirectionalLight(const Light& light);

  Rgb escape(glm::vec3) const { return Rgb(0); }
  bool wantsSampling() const { return true; }
  std::optional<LightSample> sample(glm::vec3 p, Random& random) const;
  float pdf(glm::vec3) const { return 0; }

 private:
  glm::vec3 direction_;
  float irradiance_;
};

}  // namespace loomlight
