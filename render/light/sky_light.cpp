#include "render/light/sky_light.h"

#include <cmath>
#include <limits>
#include <vector>

#include "render/light/lat_long.h"

// How it works. Light is sampled from the sun with a chance as large as its share of the power, else from a table of
// the sky's luminance (SphereTable); what is sampled is weighted by the density of both together (Veach 1997,
// one-sample model). The sun is a cap of a quarter of a degree; its cosine has no digits left there, so it is
// measured by the chord. Cost: one search in the table.

namespace loomlight {
namespace {

constexpr int kTableWidth = 128, kTableHeight = 64;  // the horizon falls between two rows

constexpr double kSunHalfAngle = Daylight::sunHalfAngle_deg * kPi / 180;
/// 1 - cos of the half angle; written so that the difference keeps its digits.
const double kSunCap = 2 * std::pow(std::sin(kSunHalfAngle / 2), 2);
const double kSunSolidAngle = 2 * kPi * kSunCap;

SphereTable tabulate(const Daylight& daylight) {
  std::vector<float> values;
  values.reserve(static_cast<size_t>(kTableWidth) * kTableHeight);
  for (int y = 0; y < kTableHeight; ++y) {
    const auto cosTheta = static_cast<float>(std::cos(kPi * (y + 0.5) / kTableHeight));
    for (int x = 0; x < kTableWidth; ++x)
      values.push_back(
          luminance(daylight.radiance(latLongDirection((static_cast<float>(x) + 0.5f) / kTableWidth, cosTheta))));
  }
  return SphereTable(kTableWidth, kTableHeight, values);
}

}  // namespace

SkyLight::SkyLight(const Light& light)
    : daylight_(light.turbidity, light.azimuth_deg, light.elevation_deg),
      intensity_(static_cast<float>(light.intensity)),
      table_(tabulate(daylight_)) {
  const double sunPower = luminance(daylight_.sunRadiance()) * kSunSolidAngle;
  if (sunPower > 0) sunChance_ = static_cast<float>(sunPower / (sunPower + table_.power()));
  const glm::vec3 s = daylight_.sunDirection();
  sunX_ = glm::normalize(glm::cross(s, std::abs(s.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0)));
  sunY_ = glm::cross(s, sunX_);
}

/// By the chord, because the cosine of so small an angle has lost its digits.
bool SkyLight::inSun(glm::vec3 d) const {
  const glm::vec3 chord = d - daylight_.sunDirection();
  return glm::dot(chord, chord) < static_cast<float>(2 * kSunCap);
}

Rgb SkyLight::escape(glm::vec3 d) const {
  Rgb radiance = daylight_.radiance(d);
  if (inSun(d) && d.z > 0) radiance += daylight_.sunRadiance();
  return radiance * intensity_;
}

float SkyLight::pdf(glm::vec3 d) const {
  return mixture(table_.pdf(d), inSun(d));
}

float SkyLight::mixture(float tablePdf, bool inSun) const {
  return (1 - sunChance_) * tablePdf + (inSun ? sunChance_ * static_cast<float>(1 / kSunSolidAngle) : 0.0f);
}

glm::vec3 SkyLight::sunPoint(Random::Pair u) const {
  const float cap = u.first * static_cast<float>(kSunCap);
  const float r = std::sqrt(cap * (2 - cap));
  const optics::SinCos<float> about = optics::sinCosPi(2 * u.second - 1);
  return glm::normalize((1 - cap) * daylight_.sunDirection() + r * (about.cosine * sunX_ + about.sine * sunY_));
}

std::optional<LightSample> SkyLight::sample(glm::vec3, Random& random) const {
  if (!(intensity_ > 0 && (table_.power() > 0 || sunChance_ > 0))) return std::nullopt;
  SphereTable::Sample chosen;
  if (random.uniform() < sunChance_) {
    chosen.direction = sunPoint(random.uniformPair());
    chosen.pdf = table_.pdf(chosen.direction);
  } else {
    chosen = table_.sample(random);
  }
  const float pdf = mixture(chosen.pdf, inSun(chosen.direction));
  // A direction on the very edge of the sun may round out of it, over a part of the table that is never drawn.
  if (!(pdf > 0)) return std::nullopt;
  return LightSample{chosen.direction, std::numeric_limits<float>::infinity(), pdf};
}

}  // namespace loomlight
