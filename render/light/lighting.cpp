#include "render/light/lighting.h"

#include "render/colour/spectrum.h"
#include "render/light/surroundings.h"

namespace loomlight {
namespace {

using AnyLight = std::variant<UniformLight, SkyLight, EnvironmentLight, Headlight, DirectionalLight>;

AnyLight makeLight(const Light& light, glm::vec3 eye_mm, float reach_mm, const AnyLight* same) {
  if (const auto* known = same ? std::get_if<EnvironmentLight>(same) : nullptr) return EnvironmentLight(*known, light);
  const auto intensity = static_cast<float>(light.intensity);
  switch (light.kind) {
    case LightKind::sky:
      return SkyLight(light);
    case LightKind::overcast:
      return EnvironmentLight(overcastSky(), light, "overcast sky");
    case LightKind::window:
      return EnvironmentLight(windowedRoom(), light, "window");
    case LightKind::booth:
      return EnvironmentLight(lightBooth(), light, "light booth");
    case LightKind::dome:
      return UniformLight(intensity, 0);
    case LightKind::furnace:
      return UniformLight(intensity, intensity);
    case LightKind::back:
      return UniformLight(0, intensity);
    case LightKind::headlight:
      return Headlight(intensity, eye_mm, reach_mm);
    case LightKind::directional:
      return DirectionalLight(light);
    case LightKind::environment:
      return EnvironmentLight(light);
  }
  return UniformLight(0, 0);
}

std::filesystem::file_time_type writtenAt(const Light& light) {
  std::error_code missing;  // reading it will say so
  return light.kind == LightKind::environment ? std::filesystem::last_write_time(light.file, missing)
                                              : std::filesystem::file_time_type::min();
}

}  // namespace

Lighting::Lighting(const Light& light, glm::vec3 eye_mm, float reach_mm, const Lighting* sameAround)
    : written_(writtenAt(light)),
      light_(makeLight(light, eye_mm, reach_mm,
                       sameAround && sameAround->written_ == written_ ? &sameAround->light_ : nullptr)),
      tint_(tint(light)) {}

Rgb Lighting::tint(const Light& light) {
  return light.illuminant == StandardIlluminant::blackBody ? Rgb(1) : blackBodyTint(light.temperature_K);
}

Lighting::Lighting(const Light& light, glm::vec3 eye_mm) : Lighting(light, eye_mm, glm::length(eye_mm)) {}

Rgb Lighting::escape(glm::vec3 d) const {
  return tint_ * std::visit([&](const auto& light) { return light.escape(d); }, light_);
}

bool Lighting::wantsSampling() const {
  return std::visit([](const auto& light) { return light.wantsSampling(); }, light_);
}

bool Lighting::isDelta() const {
  return std::holds_alternative<Headlight>(light_) || std::holds_alternative<DirectionalLight>(light_);
}

std::optional<LightSample> Lighting::sample(glm::vec3 p, Random& random) const {
  return std::visit([&](const auto& light) { return light.sample(p, random); }, light_);
}

Rgb Lighting::radiance(const LightSample& sample) const {
  return sample.isDelta() ? tint_ * sample.irradiance : escape(sample.wi);
}

float Lighting::pdf(glm::vec3 d) const {
  return std::visit([&](const auto& light) { return light.pdf(d); }, light_);
}

}  // namespace loomlight
