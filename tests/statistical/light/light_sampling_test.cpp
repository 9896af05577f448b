#include <gtest/gtest.h>

#include <cmath>

#include "render/film/image.h"
#include "render/light/daylight.h"
#include "render/light/environment_light.h"
#include "render/light/lat_long.h"
#include "render/light/lighting.h"
#include "render/light/sphere_table.h"
#include "tests/statistical/chi_square.h"

namespace loomlight {
namespace {

using test::chiSquareOnInterval;
using test::chiSquareOnSphere;
using test::ChiSquareSettings;
using test::fits;

constexpr double kSunHalfAngle = Daylight::sunHalfAngle_deg * kPi / 180;

/// Tables are constant in cells, which the bins cut: many panels, so that the quadrature sees the edges.
constexpr ChiSquareSettings kFine{.samples = 200000, .bins = 21, .quadrature = 10};

Light sky(double elevation_deg, double turbidity) {
  Light light;
  light.elevation_deg = elevation_deg;
  light.turbidity = turbidity;
  return light;
}

/// Hard on samplers: a black quarter, one bright point, noise over orders of magnitude.
Image roughImage(int width, float brightest) {
  Image image;
  image.width = width;
  image.height = width / 2;
  Random random(17);
  for (const char* name : {"R", "G", "B"}) {
    std::vector<float>& values = image.add(name);
    for (float& v : values) v = std::exp(6 * random.uniform() - 4);
    for (size_t i = values.size() / 2; i < values.size() * 3 / 4; ++i) values[i] = 0;
    values[values.size() / 3] = brightest;
  }
  return image;
}

EnvironmentLight roughEnvironment(int width, float brightest) {
  Light light;
  light.kind = LightKind::environment;
  light.azimuth_deg = 40;
  return EnvironmentLight(roughImage(width, brightest), light, "rough");
}

template <class AnyLight>
test::ChiSquare testOf(const AnyLight& lighting) {
  return chiSquareOnSphere(
      [&](Random& random) -> std::optional<glm::vec3> {
        const auto sample = lighting.sample({0, 0, 0}, random);
        if (!sample) return std::nullopt;
        return sample->wi;
      },
      [&](glm::vec3 d) { return lighting.pdf(d); }, kFine);
}

TEST(LightSampling, UniformLightsFitTheirDensity) {
  for (const LightKind kind : {LightKind::dome, LightKind::furnace, LightKind::back}) {
    Light light;
    light.kind = kind;
    const test::ChiSquare test = testOf(Lighting(light, {0, 0, 60}));
    EXPECT_TRUE(fits(test, 3));
    EXPECT_NEAR(test.integral, 1, 2e-3);
  }
}

TEST(LightSampling, TablesFitTheirDensity) {
  Random values(23);
  std::vector<float> radiance(16 * 8);
  for (float& v : radiance) v = values.uniform() < 0.3f ? 0 : std::exp(4 * values.uniform());
  std::fill(radiance.begin() + 16 * 3, radiance.begin() + 16 * 4, 0.0f);  // a row that is never drawn
  const SphereTable table(16, 8, radiance);
  const test::ChiSquare test =
      chiSquareOnSphere([&](Random& random) -> std::optional<glm::vec3> { return table.sample(random).direction; },
                        [&](glm::vec3 d) { return table.pdf(d); }, kFine);
  EXPECT_TRUE(fits(test));
  EXPECT_NEAR(test.integral, 1, 2e-3);
}

TEST(LightSampling, SampleAndDensityOfATableAgreeWhereverItDraws) {
  const EnvironmentLight light = roughEnvironment(64, 2000);
  Random random(2);
  int differing = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto sample = light.sample({0, 0, 0}, random);
    if (sample && std::abs(sample->pdf - light.pdf(sample->wi)) > 1e-4f * sample->pdf) ++differing;
  }
  EXPECT_LT(differing, 20);  // directions on the edge of two cells, which rounding carries over
}

TEST(LightSampling, EnvironmentFitsItsDensity) {
  EXPECT_TRUE(fits(testOf(roughEnvironment(32, 20))));
}

/// The sky without its sun, which no bin of the whole sphere resolves: its draws are dropped, its share of the density
/// is in the bin for nothing.
TEST(LightSampling, SkyFitsItsDensity) {
  const std::vector<Light> skies{sky(45, 3), sky(5, 2), sky(80, 10), sky(-3, 4)};
  for (const Light& light : skies) {
    const Lighting lighting(light, {0, 0, 60});
    const glm::vec3 sun = directionOf(light.azimuth_deg, light.elevation_deg);
    const auto inSun = [&](glm::vec3 d) { return glm::distance(d, sun) < 1.01 * kSunHalfAngle; };
    const test::ChiSquare test = chiSquareOnSphere(
        [&](Random& random) -> std::optional<glm::vec3> {
          const auto sample = lighting.sample({0, 0, 0}, random);
          if (!sample || inSun(sample->wi)) return std::nullopt;
          return sample->wi;
        },
        [&](glm::vec3 d) { return inSun(d) ? 0.0f : lighting.pdf(d); }, kFine);
    EXPECT_TRUE(fits(test, static_cast<int>(skies.size()))) << light.elevation_deg;
  }
}

TEST(LightSampling, SunIsDrawnEvenlyOverItsDisc) {
  const Lighting lighting(sky(45, 3), {0, 0, 60});
  const glm::dvec3 sun = directionOf(130, 45), x = glm::normalize(glm::cross(sun, glm::dvec3(0, 0, 1))),
                   y = glm::cross(sun, x);
  const auto draw = [&](Random& random) -> std::optional<glm::dvec3> {
    const auto sample = lighting.sample({0, 0, 0}, random);
    if (!sample || glm::distance(glm::dvec3(sample->wi), sun) > 1.001 * kSunHalfAngle) return std::nullopt;
    return glm::dvec3(sample->wi);
  };
  // The cap's share of the mixture, and in it the square of the chord is uniform, and the angle.
  const double share = lighting.pdf(glm::vec3(sun)) * 2 * kPi * (1 - std::cos(kSunHalfAngle));
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 1.0);
  const double chord2 = std::pow(2 * std::sin(kSunHalfAngle / 2), 2);
  EXPECT_TRUE(fits(chiSquareOnInterval(
                       0, chord2,
                       [&](Random& random) -> std::optional<double> {
                         const auto d = draw(random);
                         if (!d) return std::nullopt;
                         return glm::dot(*d - sun, *d - sun);
                       },
                       [&](double) { return share / chord2; }, {.bins = 20}),
                   2));
  EXPECT_TRUE(fits(chiSquareOnInterval(
                       -kPi, kPi,
                       [&](Random& random) -> std::optional<double> {
                         const auto d = draw(random);
                         if (!d) return std::nullopt;
                         return std::atan2(glm::dot(*d, y), glm::dot(*d, x));
                       },
                       [&](double) { return share / (2 * kPi); }, {.bins = 20, .seed = 2}),
                   2));
}

/// Luminous irradiance of the horizontal from escape(): midpoints even in the cosine, and a fine polar grid around the
/// sun, whose edge falls between two of its rings.
template <class AnyLight>
double irradianceByQuadrature(const AnyLight& lighting, glm::dvec3 sun, int n) {
  const double cap = 4 * kSunHalfAngle;
  const int rows = n / 2;
  double sum = 0;
  for (int row = 0; row < rows; ++row) {
    const double z = (row + 0.5) / rows;
    for (int column = 0; column < n; ++column) {
      const glm::vec3 d =
          latLongDirection((static_cast<float>(column) + 0.5f) / static_cast<float>(n), static_cast<float>(z));
      if (glm::dot(glm::dvec3(d), sun) > std::cos(cap)) continue;
      sum += luminance(lighting.escape(d)) * z * (2 * kPi / n) / rows;
    }
  }
  const glm::dvec3 x = glm::normalize(glm::cross(sun, glm::dvec3(0.3, 0.2, 0.9))), y = glm::cross(sun, x);
  constexpr int kRings = 200, kSpokes = 64;
  for (int ring = 0; ring < kRings; ++ring) {
    const double inner = cap * ring / kRings, outer = cap * (ring + 1) / kRings, middle = 0.5 * (inner + outer);
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double angle = 2 * kPi * (spoke + 0.5) / kSpokes;
      const glm::dvec3 d = std::cos(middle) * sun + std::sin(middle) * (std::cos(angle) * x + std::sin(angle) * y);
      if (d.z <= 0) continue;
      sum += luminance(lighting.escape(glm::vec3(d))) * d.z * (std::cos(inner) - std::cos(outer)) * (2 * kPi / kSpokes);
    }
  }
  return sum;
}

template <class AnyLight>
void expectSamplesGiveTheIrradianceOf(const AnyLight& lighting, glm::dvec3 sun, int n) {
  constexpr int kSamples = 200000;
  Random random(31);
  double sum = 0, squares = 0;
  for (int i = 0; i < kSamples; ++i) {
    const auto sample = lighting.sample({0, 0, 0}, random);
    if (!sample || sample->wi.z <= 0) continue;
    const double value = luminance(lighting.escape(sample->wi)) * sample->wi.z / sample->pdf;
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kSamples;
  const double standardError = std::sqrt((squares / kSamples - mean * mean) / kSamples);
  const double expected = irradianceByQuadrature(lighting, sun, n);
  // Three standard errors, and the quadrature's own error.
  EXPECT_NEAR(mean, expected, 3 * standardError + 2e-4 * expected);
  if (expected > 0) {
    EXPECT_LT(standardError, 0.005 * expected);
  }
}

TEST(LightSampling, SamplesGiveTheIrradianceThatEscapeSees) {
  for (const LightKind kind : {LightKind::dome, LightKind::furnace, LightKind::back}) {
    Light light;
    light.kind = kind;
    expectSamplesGiveTheIrradianceOf(Lighting(light, {0, 0, 60}), {0, 0, 1}, 256);
  }
  for (const Light& light : {sky(45, 3), sky(90, 2), sky(10, 5), sky(0, 3), sky(-4, 3)})
    expectSamplesGiveTheIrradianceOf(Lighting(light, {0, 0, 60}), directionOf(light.azimuth_deg, light.elevation_deg),
                                     1024);
  expectSamplesGiveTheIrradianceOf(roughEnvironment(64, 2000), {0, 0, 1}, 2048);
}

}  // namespace
}  // namespace loomlight
