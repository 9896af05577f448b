#include "render/light/environment_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "render/film/image.h"
#include "render/light/lat_long.h"
#include "render/light/lighting.h"
#include "tests/support/surroundings.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

Image blank(int width, int height, float value = 0) {
  Image image;
  image.width = width;
  image.height = height;
  for (const char* name : {"R", "G", "B"}) {
    std::vector<float>& values = image.add(name);
    std::fill(values.begin(), values.end(), value);
  }
  return image;
}

Light turned(double azimuth_deg) {
  Light light;
  light.kind = LightKind::environment;
  light.azimuth_deg = azimuth_deg;
  return light;
}

std::string complaint(const Image& image) {
  try {
    EnvironmentLight(image, turned(0), "room.exr");
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

TEST(EnvironmentLight, MiddleOfTheImageLiesAtTheAzimuth) {
  Image image = blank(64, 32);
  for (const size_t row : {15u, 16u})
    for (const size_t column : {31u, 32u}) image.channels[1].values[row * 64 + column] = 5;
  EXPECT_NEAR(EnvironmentLight(image, turned(0), "").escape({1, 0, 0}).g, 5, 1e-4f);
  EXPECT_NEAR(EnvironmentLight(image, turned(90), "").escape({0, 1, 0}).g, 5, 1e-4f);
  EXPECT_EQ(EnvironmentLight(image, turned(90), "").escape({1, 0, 0}).g, 0);
}

TEST(EnvironmentLight, TopIsUpAndRightIsRight) {
  Image image = blank(64, 32);
  for (size_t i = 0; i < 64 * 8; ++i) image.channels[2].values[i] = 1;                // the upper quarter is blue
  for (size_t row = 0; row < 32; ++row) image.channels[0].values[row * 64 + 48] = 1;  // red a quarter turn to the right
  const EnvironmentLight light(image, turned(0), "");
  EXPECT_EQ(light.escape({0, 0, 1}).b, 1);
  EXPECT_EQ(light.escape({0, 0, -1}).b, 0);
  // Looking along +x with z up, the right hand points along -y.
  EXPECT_GT(light.escape({0, -1, 0}).r, 0.4f);
  EXPECT_EQ(light.escape({0, 1, 0}).r, 0);
}

TEST(EnvironmentLight, InterpolatesAcrossTheSeam) {
  Image image = blank(8, 4);
  for (size_t row = 0; row < 4; ++row) {
    image.channels[0].values[row * 8] = 1;
    image.channels[0].values[row * 8 + 7] = 3;
  }
  EXPECT_NEAR(EnvironmentLight(image, turned(0), "").escape({-1, 0, 0}).r, 2, 1e-4f);
}

TEST(EnvironmentLight, BadValuesAreCleaned) {
  Image image = blank(4, 2, 1);
  image.channels[0].values = {kNan, kInfinity, -3, -kInfinity, 1, 1, 1, 7};
  const EnvironmentLight light(image, turned(0), "");
  const auto at = [&](int x, int y) {
    return light
        .escape(latLongDirection((static_cast<float>(x) + 0.5f) / 4, y == 0 ? std::sqrt(0.5f) : -std::sqrt(0.5f)))
        .r;
  };
  EXPECT_NEAR(at(0, 0), 0, 1e-5f);
  EXPECT_NEAR(at(1, 0), 7, 1e-5f);  // the brightest that was measured
  EXPECT_NEAR(at(2, 0), 0, 1e-5f);
  EXPECT_NEAR(at(3, 0), 0, 1e-5f);
  EXPECT_NEAR(at(3, 1), 7, 1e-5f);
}

TEST(EnvironmentLight, NothingFiniteIsBlackAndHarmless) {
  const EnvironmentLight light(blank(4, 2, kNan), turned(0), "");
  Random random(1);
  EXPECT_EQ(light.escape({1, 0, 0}), Rgb(0));
  EXPECT_FALSE(light.sample({0, 0, 0}, random).has_value());
  EXPECT_NEAR(light.pdf({1, 0, 0}), 0.25 / kPi, 1e-6);
}

TEST(EnvironmentLight, LargeImagesAreAveragedAndKeepTheirPower) {
  Image image = blank(4098, 2049, 0.5f);
  for (size_t i = 0; i < image.channels[0].values.size(); i += 2) image.channels[0].values[i] = 1.5f;
  const EnvironmentLight light(std::move(image), turned(0), "");
  for (const glm::vec3 d : {glm::vec3(1, 0, 0), glm::vec3(0, 0.6f, 0.8f), glm::vec3(0, 0, -1)}) {
    EXPECT_NEAR(light.escape(d).r, 1, 1e-6f);
    EXPECT_NEAR(light.escape(d).g, 0.5f, 1e-6f);
  }
}

TEST(EnvironmentLight, GreyImagesLightInGrey) {
  Image image;
  image.width = 4;
  image.height = 2;
  image.add("Y").assign(8, 0.25f);
  EXPECT_EQ(EnvironmentLight(image, turned(0), "").escape({1, 0, 0}), Rgb(0.25f));
}

TEST(EnvironmentLight, RefusesWhatIsNoPanorama) {
  EXPECT_THAT(complaint(blank(64, 64)), HasSubstr("room.exr: 64 x 64 pixels: expected a latitude-longitude image"));
  Image image = blank(4, 2);
  image.channels.pop_back();
  EXPECT_THAT(complaint(image), HasSubstr("room.exr: no channel B"));
  EXPECT_EQ(complaint(blank(64, 32)), "");
  EXPECT_EQ(complaint(blank(2000, 1001)), "");
}

TEST(EnvironmentLight, MissingFilesAreNamed) {
  Light light = turned(0);
  EXPECT_THROW(Lighting(light, {0, 0, 1}), InputError);
  light.file = "no/such/room.exr";
  try {
    Lighting lighting(light, {0, 0, 1});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("no/such/room.exr"));
  }
}

TEST(EnvironmentLight, AnImageOfTheSkyLightsLikeTheSky) {
  Light sky;
  sky.elevation_deg = -2;  // the sun is below the horizon: no pixel could show it as small as it is
  const std::string file =
      (std::filesystem::temp_directory_path() / ("loomlight-sky-" + std::to_string(getpid()) + ".exr")).string();
  writeExr(file, test::surroundings(sky, 512));
  Light exported = turned(0);
  exported.file = file;
  const Lighting original(sky, {0, 0, 1}), copy(exported, {0, 0, 1});
  std::filesystem::remove(file);
  // Radiance itself; the horizon is as sharp as a pixel.
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 d = latLongDirection(random.uniform(), 2 * random.uniform() - 1);
    if (std::abs(d.z) < 0.02f) continue;
    EXPECT_NEAR(copy.escape(d).g, original.escape(d).g, 0.02f * original.escape(d).g);
  }
  // All of it by sampling: irradiance of the horizontal.
  const auto irradiance = [](const Lighting& lighting) {
    Random r(5);
    double sum = 0;
    constexpr int n = 200000;
    for (int i = 0; i < n; ++i) {
      const auto s = lighting.sample({0, 0, 0}, r);
      if (s && s->wi.z > 0) sum += luminance(lighting.radiance(*s)) * s->wi.z / s->pdf;
    }
    return sum / n;
  };
  // Standard errors are 0.15 % each; bilinear interpolation moves the light by less than a pixel.
  EXPECT_NEAR(irradiance(copy) / irradiance(original), 1, 0.015);
}

}  // namespace
}  // namespace loomlight
