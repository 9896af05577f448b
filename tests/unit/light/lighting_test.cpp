#include "render/light/lighting.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "core/base/units.h"
#include "render/colour/spectrum.h"
#include "render/light/daylight.h"
#include "render/light/lat_long.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/surroundings.h"

namespace loomlight {
namespace {

Lighting make(LightKind kind, double intensity = 1) {
  Light light;
  light.kind = kind;
  light.intensity = intensity;
  return Lighting(light, {0, 0, 60});
}

TEST(Lighting, UniformLightsShineFromTheirSide) {
  const glm::vec3 up = glm::normalize(glm::vec3(1, 2, 0.1f)), down = glm::normalize(glm::vec3(1, 2, -0.1f));
  struct Case {
    LightKind kind;
    float above, below;
  };
  for (const Case c : {Case{LightKind::dome, 1, 0}, {LightKind::furnace, 1, 1}, {LightKind::back, 0, 1}}) {
    const Lighting lighting = make(c.kind, 2.5);
    EXPECT_EQ(lighting.escape(up), Rgb(2.5f * c.above));
    EXPECT_EQ(lighting.escape(down), Rgb(2.5f * c.below));
    EXPECT_FALSE(lighting.wantsSampling());
  }
}

TEST(Lighting, IntensityScalesRadianceAndLeavesTheDensityAlone) {
  const glm::vec3 d = glm::normalize(glm::vec3(0.3f, -0.5f, 0.6f));
  const Lighting one = make(LightKind::sky), three = make(LightKind::sky, 3);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(three.escape(d)[c], 3 * one.escape(d)[c], 1e-5f);
  EXPECT_EQ(three.pdf(d), one.pdf(d));
}

TEST(Lighting, TemperatureTintsWhatArrivesAndLeavesTheDirectionsAlone) {
  const Rgb warm = blackBodyTint(2700);
  for (const LightKind kind : {LightKind::sky, LightKind::booth, LightKind::dome, LightKind::headlight}) {
    Light light;
    light.kind = kind;
    const Lighting neutral(light, {0, 0, 60});
    light.temperature_K = 2700;
    const Lighting tinted(light, {0, 0, 60});
    Random one(3), other(3);
    for (int i = 0; i < 32; ++i) {
      const auto a = neutral.sample({0, 0, 0}, one), b = tinted.sample({0, 0, 0}, other);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) continue;
      EXPECT_EQ(a->wi, b->wi);
      EXPECT_EQ(a->pdf, b->pdf);
      EXPECT_EQ(warm * neutral.radiance(*a), tinted.radiance(*b));
      EXPECT_EQ(warm * neutral.escape(a->wi), tinted.escape(a->wi));
    }
  }
}

TEST(Lighting, NothingArrivesFromADarkLight) {
  Random random(1);
  for (const LightKind kind : {LightKind::sky, LightKind::dome, LightKind::headlight, LightKind::directional})
    EXPECT_FALSE(make(kind, 0).sample({1, 2, 3}, random).has_value());
}

TEST(Lighting, HeadlightFallsWithTheSquareOfTheDistance) {
  Random random(1);
  const Lighting lighting = make(LightKind::headlight, 2);
  const auto atOrigin = lighting.sample({0, 0, 0}, random), closer = lighting.sample({0, 0, 30}, random);
  ASSERT_TRUE(atOrigin && closer);
  EXPECT_TRUE(atOrigin->isDelta());
  EXPECT_EQ(atOrigin->pdf, 1);
  EXPECT_EQ(atOrigin->distance, 60);
  EXPECT_EQ(atOrigin->wi, glm::vec3(0, 0, 1));
  EXPECT_NEAR(lighting.radiance(*atOrigin).g, 2 * kPiF, 1e-5f);
  EXPECT_NEAR(lighting.radiance(*closer).g, 8 * kPiF, 1e-4f);
  EXPECT_FALSE(lighting.sample({0, 0, 60}, random).has_value());
  EXPECT_TRUE(lighting.wantsSampling());
  EXPECT_EQ(lighting.escape({0, 0, 1}), Rgb(0));
  EXPECT_EQ(lighting.pdf({0, 0, 1}), 0);
}

TEST(Lighting, DirectionalLightComesFromItsAngles) {
  Light light;
  light.kind = LightKind::directional;
  light.azimuth_deg = 90;
  light.elevation_deg = 30;
  Random random(1);
  const Lighting lighting(light, {0, 0, 60});
  const auto sample = lighting.sample({5, 5, 5}, random);
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->isDelta());
  EXPECT_NEAR(glm::distance(sample->wi, glm::vec3(0, std::cos(kPiF / 6), 0.5f)), 0, 1e-6f);
  EXPECT_NEAR(lighting.radiance(*sample).r, kPiF, 1e-5f);
  EXPECT_EQ(sample->distance, std::numeric_limits<float>::infinity());
}

TEST(Lighting, SunIsWhereItsAnglesSayAndHalfADegreeWide) {
  Light light;
  light.azimuth_deg = 130;
  light.elevation_deg = 45;
  const Lighting lighting(light, {0, 0, 60});
  const float inside = lighting.escape(directionOf(130, 45)).g, edge = lighting.escape(directionOf(130, 45.26)).g;
  const float outside = lighting.escape(directionOf(130, 45.27)).g;
  EXPECT_GT(edge, 0.99f * inside);
  EXPECT_GT(inside, 1000 * outside);
  EXPECT_GT(lighting.pdf(directionOf(130, 45.26)), 1000 * lighting.pdf(directionOf(130, 45.27)));
}

TEST(Lighting, SunBelowTheHorizonIsHidden) {
  Light light;
  light.elevation_deg = 0;  // half of the disc
  const Lighting half(light, {0, 0, 60});
  EXPECT_GT(half.escape(directionOf(130, 0.2)).r, 100 * half.escape(directionOf(130, -0.2)).r);
  light.elevation_deg = -3;
  const Lighting dusk(light, {0, 0, 60});
  EXPECT_LT(dusk.escape(directionOf(130, -3)).r, 1);
  Random random(1);
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(dusk.sample({0, 0, 0}, random).has_value());
}

TEST(Lighting, MidnightIsDarkAndHarmless) {
  Light light;
  light.elevation_deg = -90;
  const Lighting night(light, {0, 0, 60});
  Random random(1);
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(night.sample({0, 0, 0}, random).has_value());
  EXPECT_EQ(night.escape({0, 0, 1}), Rgb(0));
  EXPECT_TRUE(std::isfinite(night.pdf({0, 0, 1})));
}

TEST(Headlight, IsAsBrightOnWhatTheCameraLooksAtWhereverThatIs) {
  Light light;
  light.kind = LightKind::headlight;
  Random random(1);
  for (const glm::vec3 target : {glm::vec3(0, 0, 0), glm::vec3(12, 0, 0), glm::vec3(-300, 40, 2)}) {
    const glm::vec3 eye = target + glm::vec3(0, 0, 10);
    const Lighting lighting(light, eye, 10);
    const auto sample = lighting.sample(target, random);
    ASSERT_TRUE(sample);
    EXPECT_NEAR(lighting.radiance(*sample).g, kPi, 1e-4);  // of a delta light: its irradiance
  }
}

// A drag of the temperature must not read the file at every step, and a file that was written anew must be seen.
TEST(Lighting, ReadsAnEnvironmentOnce) {
  const test::ScratchFolder folder;
  Light light;
  light.kind = LightKind::environment;
  light.file = folder.file("room.exr");
  Light source;
  source.kind = LightKind::sky;
  writeExr(light.file, test::surroundings(source, 64));
  const Lighting first(light, {0, 0, 60}, 60);
  const auto written = std::filesystem::last_write_time(light.file);
  std::filesystem::resize_file(light.file, 10);
  std::filesystem::last_write_time(light.file, written);

  light.temperature_K = 3000;
  light.intensity = 2;
  const Lighting warmer(light, {0, 0, 60}, 60, &first);
  const glm::vec3 d = glm::normalize(glm::vec3(0.3f, -0.5f, 0.6f));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(warmer.escape(d)[c], 2 * blackBodyTint(3000)[c] * first.escape(d)[c], 1e-4f);
  EXPECT_EQ(warmer.pdf(d), first.pdf(d));

  EXPECT_THROW(Lighting(light, {0, 0, 60}, 60), InputError) << "read";
  std::filesystem::last_write_time(light.file, written + std::chrono::seconds(1));
  EXPECT_THROW(Lighting(light, {0, 0, 60}, 60, &warmer), InputError) << "read again";
}

}  // namespace
}  // namespace loomlight
