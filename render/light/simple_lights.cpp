#include "render/light/simple_lights.h"

#include <cmath>
#include <limits>

#include "render/light/lat_long.h"

namespace loomlight {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

std::optional<LightSample> UniformLight::sample(glm::vec3, Random& random) const {
  const float side = random.uniform() < chanceAbove() ? 1.0f : -1.0f;
  const float z = side * (1 - random.uniform());  // never 0
  const glm::vec3 wi = latLongDirection(random.uniform(), z);
  if (escape(wi) == Rgb(0)) return std::nullopt;
  return LightSample{wi, kInfinity, pdf(wi)};
}

float UniformLight::pdf(glm::vec3 d) const {
  return (d.z > 0 ? chanceAbove() : 1 - chanceAbove()) * static_cast<float>(0.5 / kPi);
}

Headlight::Headlight(float intensity, glm::vec3 eye_mm, float reach_mm)
    : position_(eye_mm), power_(static_cast<float>(kPi) * intensity * reach_mm * reach_mm) {}

std::optional<LightSample> Headlight::sample(glm::vec3 p, Random&) const {
  const glm::vec3 way = position_ - p;
  const float distance2 = glm::dot(way, way);
  if (!(distance2 > 0) || power_ <= 0) return std::nullopt;
  const float distance = std::sqrt(distance2);
  return LightSample{way / distance, distance, 1, power_ / distance2};
}

DirectionalLight::DirectionalLight(const Light& light)
    : direction_(directionOf(light.azimuth_deg, light.elevation_deg)),
      irradiance_(static_cast<float>(kPi * light.intensity)) {}

std::optional<LightSample> DirectionalLight::sample(glm::vec3, Random&) const {
  if (irradiance_ <= 0) return std::nullopt;
  return LightSample{direction_, kInfinity, 1, irradiance_};
}

}  // namespace loomlight
