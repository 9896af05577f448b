#include "render/light/daylight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/light/lat_long.h"

namespace loomlight {
namespace {

constexpr double kSunHalfAngle = Daylight::sunHalfAngle_deg * kPi / 180;

double luminance(glm::dvec3 c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

/// Irradiance of a horizontal plane, without the sun: midpoints of a grid that is even in sin^2 of the zenith angle.
glm::dvec3 skyIrradiance(const Daylight& daylight, int n = 256) {
  glm::dvec3 sum(0);
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const auto cosTheta = static_cast<float>(std::sqrt((y + 0.5) / n));
      sum += glm::dvec3(
          daylight.radiance(latLongDirection((static_cast<float>(x) + 0.5f) / static_cast<float>(n), cosTheta)));
    }
  }
  return sum * (kPi / (n * n));
}

/// A disc small against the cosine: radiance, times projected solid angle, times cosine.
glm::dvec3 sunIrradiance(const Daylight& daylight) {
  const double s = std::sin(kSunHalfAngle);
  return glm::dvec3(daylight.sunRadiance()) * (kPi * s * s * std::max(0.0f, daylight.sunDirection().z));
}

TEST(Daylight, WhitePaperUnderTheDefaultSkyIsWhite) {
  const Daylight daylight(3, 130, 45);
  const glm::dvec3 paper = (skyIrradiance(daylight) + sunIrradiance(daylight)) / kPi;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(paper[c], 1, 2e-3);
}

TEST(Daylight, IsFiniteAndNeverNegative) {
  for (double elevation = -90; elevation <= 90; elevation += 2.5) {
    for (const double turbidity : {-5.0, 2.0, 2.5, 3.0, 5.0, 7.5, 10.0, 50.0}) {
      const Daylight daylight(turbidity, 33, elevation);
      for (int c = 0; c < 3; ++c) {
        EXPECT_TRUE(std::isfinite(daylight.sunRadiance()[c]));
        EXPECT_GE(daylight.sunRadiance()[c], 0);
      }
      for (int y = 0; y <= 40; ++y) {
        for (int x = 0; x < 24; ++x) {
          const Rgb radiance = daylight.radiance(latLongDirection(x / 24.0f, 1 - y / 20.0f));
          for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(std::isfinite(radiance[c])) << elevation << " " << turbidity << " " << x << " " << y;
            ASSERT_GE(radiance[c], 0);
          }
        }
      }
    }
  }
}

TEST(Daylight, SunDimsAndReddensTowardsTheHorizon) {
  double lastLuminance = 1e30, lastRatio = 0;
  for (const double elevation : {90.0, 60.0, 30.0, 15.0, 8.0, 4.0}) {
    const Rgb sun = Daylight(3, 0, elevation).sunRadiance();
    EXPECT_LT(luminance(sun), lastLuminance);
    EXPECT_GT(sun.r / sun.b, lastRatio);
    lastLuminance = luminance(sun);
    lastRatio = sun.r / sun.b;
  }
}

TEST(Daylight, SunOutshinesTheSkyWhenClearAndNotInHaze) {
  const Daylight clear(2, 0, 45), haze(10, 0, 45);
  EXPECT_GT(luminance(sunIrradiance(clear)), 2 * luminance(skyIrradiance(clear)));
  EXPECT_LT(luminance(sunIrradiance(haze)), luminance(skyIrradiance(haze)));
}

TEST(Daylight, ClearSkyIsBluerThanItsSun) {
  const Daylight daylight(3, 0, 45);
  const glm::dvec3 sky = skyIrradiance(daylight), sun = sunIrradiance(daylight);
  EXPECT_GT(sky.z / sky.x, 1.5 * sun.z / sun.x);
}

TEST(Daylight, TransmittanceIsThatOfTheClearAir) {
  // 0.627 at 550 nm with turbidity 3 and air mass 1.41, by hand; the white balance of the luminance is within 3 %.
  // Zero air mass cannot be asked for, so compare heights: the ratio of two paths' transmittances.
  const double high = luminance(Daylight(3, 0, 90).sunRadiance()), low = luminance(Daylight(3, 0, 45).sunRadiance());
  EXPECT_NEAR(low / high, std::pow(0.627, 1 - 1 / 1.41), 0.02);
}

TEST(Daylight, NightFallsWithoutASun) {
  double last = luminance(skyIrradiance(Daylight(3, 0, 1), 64));
  for (const double elevation : {-0.5, -2.0, -4.0, -5.9}) {
    const Daylight dusk(3, 0, elevation);
    const double now = luminance(skyIrradiance(dusk, 64));
    EXPECT_LT(now, last);
    EXPECT_GT(now, 0);
    EXPECT_EQ(dusk.sunRadiance() == Rgb(0), elevation < -0.3);
    last = now;
  }
  EXPECT_EQ(Daylight(3, 0, -6).radiance({0, 0, 1}), Rgb(0));
  EXPECT_EQ(Daylight(3, 0, -50).radiance({0, 0, -1}), Rgb(0));
}

TEST(Daylight, SkyIsBrightestAroundTheSun) {
  const Daylight daylight(3, 70, 30);
  const Rgb near = daylight.radiance(directionOf(75, 33));
  for (const double azimuth : {120.0, 200.0, 250.0, 330.0})
    EXPECT_LT(luminance(daylight.radiance(directionOf(azimuth, 33))), luminance(near));
}

TEST(Daylight, GroundReflectsAFifthOfItsIrradiance) {
  const Daylight daylight(4, 10, 35);
  const glm::dvec3 expected = (skyIrradiance(daylight) + sunIrradiance(daylight)) * (0.2 / kPi);
  const Rgb ground = daylight.radiance(glm::normalize(glm::vec3(1, 2, -0.5f)));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(ground[c], expected[c], 0.01 * expected[c]);
}

}  // namespace
}  // namespace loomlight
