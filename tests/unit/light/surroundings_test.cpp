#include "render/light/surroundings.h"

#include <gtest/gtest.h>

#include "render/light/lighting.h"

namespace loomlight {
namespace {

Lighting lightOf(LightKind kind, double azimuth_deg) {
  Light light;
  light.kind = kind;
  light.azimuth_deg = azimuth_deg;
  return Lighting(light, glm::vec3(0, 0, 1));
}

/// Radiance of white paper that lies in the light, by sampling the lamp; the mean over many samples.
double paper(const Lighting& light) {
  Random random(3);
  double sum = 0;
  constexpr int kSamples = 60000;
  for (int i = 0; i < kSamples; ++i)
    if (const auto sample = light.sample(glm::vec3(0), random); sample && sample->wi.z > 0)
      sum += light.radiance(*sample).g * sample->wi.z / (kPi * sample->pdf);
  return sum / kSamples;
}

TEST(Surroundings, LightPaperToRadianceOne) {
  for (const LightKind kind : {LightKind::overcast, LightKind::window, LightKind::booth})
    EXPECT_NEAR(paper(lightOf(kind, 70)), 1, 0.015) << static_cast<int>(kind);
}

TEST(Surroundings, OvercastIsThreeTimesAsBrightAtTheZenith) {
  const Lighting sky = lightOf(LightKind::overcast, 0);
  const glm::vec3 low = glm::normalize(glm::vec3(1, 0, 0.02f));
  EXPECT_NEAR(sky.escape({0, 0, 1}).g / sky.escape(low).g, 3 / (1 + 2 * low.z), 0.06);
  EXPECT_NEAR(sky.escape({0, 0, 1}).g, 9.0 / 7, 0.01);
}

TEST(Surroundings, WindowIsInTheDirectionOfTheAzimuth) {
  const Lighting room = lightOf(LightKind::window, 90);
  const glm::vec3 out = glm::normalize(glm::vec3(0, 1.5f, 0.8f));
  for (const glm::vec3 wall :
       {glm::vec3(0, -1, 0.2f), glm::vec3(1, 0, 0.2f), glm::vec3(-1, 0, 0.2f), glm::vec3(0, 0, 1)})
    EXPECT_GT(room.escape(out).g, 4 * room.escape(glm::normalize(wall)).g);
}

TEST(Surroundings, BoothIsLitFromAboveAndOpenToTheFront) {
  const Lighting booth = lightOf(LightKind::booth, -90);
  const float lamp = booth.escape({0, 0, 1}).g, back = booth.escape(glm::normalize(glm::vec3(0, 1, 0.3f))).g;
  const float front = booth.escape(glm::normalize(glm::vec3(0, -1, 0.3f))).g;
  EXPECT_GT(lamp, 5 * back);
  EXPECT_GT(back, 4 * front);
}

}  // namespace
}  // namespace loomlight
