#pragma once

#include <filesystem>
#include <optional>
#include <variant>

#include "core/base/random.h"
#include "core/fabric/model/fabric.h"
#include "render/light/environment_light.h"
#include "render/light/light_sample.h"
#include "render/light/simple_lights.h"
#include "render/light/sky_light.h"

namespace loomlight {

/// All the light of a scene, from far away or from the headlight. Immutable.
class Lighting {
 public:
  /// Loads or computes the environment. `eye_mm` is where the headlight shines from, `reach_mm` how far away intensity
  /// 1 lights white paper to radiance 1: the camera's distance from what it looks at. `sameAround` (may be null) has
  /// the same surroundings (no Stage::surroundings): its image serves again, unless the file has been written since.
  /// Throws InputError for a bad file.
  Lighting(const Light& light, glm::vec3 eye_mm, float reach_mm, const Lighting* sameAround = nullptr);
  /// Looking at the origin.
  Lighting(const Light& light, glm::vec3 eye_mm);

  /// Radiance that a ray leaving the scene in direction `d` meets. Delta lights are not in it.
  Rgb escape(glm::vec3 d) const;
  /// Whether sampling lights is worth its shadow rays; false for the white dome, which BCSDF sampling finds as well.
  bool wantsSampling() const;
  /// Whether its light can only be found by sampling it.
  bool isDelta() const;
  /// One light, one direction; nullopt when nothing can arrive at p.
  std::optional<LightSample> sample(glm::vec3 p, Random& random) const;
  /// What arrives from there, unless something is in the way: of all lights of some size; of a delta light its
  /// irradiance across wi. May be 0.
  Rgb radiance(const LightSample& sample) const;
  /// The pdf with which sample() chooses the non-delta direction d.
  float pdf(glm::vec3 d) const;

  /// How its temperature tints white light, of luminance 1; a black body's spectrum is the colouring's, and tints
  /// nothing here.
  static Rgb tint(const Light& light);

 private:
  std::filesystem::file_time_type written_;  ///< the file; the earliest of all where there is none
  std::variant<UniformLight, SkyLight, EnvironmentLight, Headlight, DirectionalLight> light_;
  Rgb tint_;  ///< of its temperature; directions are chosen without it
};

}  // namespace loomlight
