#include "render/colour/tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace loomlight {
namespace {

float decode(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

Rgb linearShown(Rgb light, const Tone& tone = {}) {
  const Rgb v = toDisplay(light, tone);
  return {decode(v.r), decode(v.g), decode(v.b)};
}

TEST(Tone, MidTonesStayWhatTheyAre) {
  for (const float v : {0.0f, 0.001f, 0.05f, 0.18f, 0.5f, 0.7f}) EXPECT_NEAR(linearShown(Rgb(v)).g, v, 2e-6f);
}

TEST(Tone, WhitePaperShowsJustBelowWhite) {
  EXPECT_NEAR(linearShown(Rgb(1)).r, 0.85f, 1e-5f);
  EXPECT_NEAR(toDisplay(Rgb(1), {}).r * 255, 237, 0.5f);
  EXPECT_LT(toDisplay(Rgb(1e4f), {}).r, 1.0f);
}

TEST(Tone, ShoulderIsMonotonicAndSmoothAtTheKnee) {
  float last = -1;
  for (float v = 0; v < 20; v += 0.01f) {
    const float shown = linearShown(Rgb(v)).b;
    EXPECT_GT(shown, last);
    last = shown;
  }
  const auto slope = [](float at) { return (linearShown(Rgb(at + 1e-2f)).r - linearShown(Rgb(at)).r) / 1e-2f; };
  EXPECT_NEAR(slope(0.69f), 1, 1e-3f);
  EXPECT_NEAR(slope(0.70f), 1, 0.04f);  // second derivative -2 / 0.3
}

TEST(Tone, HueAndSaturationStay) {
  const Rgb light(6, 1.5f, 0.75f), shown = linearShown(light);
  EXPECT_NEAR(shown.r / shown.g, 4, 1e-3f);
  EXPECT_NEAR(shown.g / shown.b, 2, 1e-3f);
}

TEST(Tone, ExposureIsInStops) {
  EXPECT_EQ(toDisplay(Rgb(0.1f), {.exposure_stops = 2}), toDisplay(Rgb(0.4f), {}));
}

TEST(Tone, WithoutShoulderItClips) {
  const Tone plain{.filmic = false};
  EXPECT_NEAR(linearShown(Rgb(0.9f), plain).r, 0.9f, 1e-5f);
  EXPECT_NEAR(toDisplay(Rgb(3), plain).r, 1, 1e-6f);
}

/// A perfect diffuser in light of intensity 1 is white, and half of its light is half of white's.
TEST(Tone, PlainIsLinearUpToThePerfectDiffuser) {
  EXPECT_FLOAT_EQ(toDisplay(Rgb(1), plainTone()).r, 1);
  for (float v = 0; v <= 1; v += 0.01f) EXPECT_NEAR(linearShown(Rgb(v), plainTone()).g, v, 2e-6f);
  EXPECT_EQ(toDisplay(Rgb(2, 1, 0.5f), plainTone()), toDisplay(Rgb(1, 1, 0.5f), plainTone())) << "each for itself";
}

TEST(Tone, AnyFloatGivesAColour) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (const bool filmic : {false, true}) {
    for (const Rgb light : {Rgb(nan, 1, 1), Rgb(infinity, 0, 1), Rgb(-infinity, -1, 0), Rgb(3e38f)}) {
      const Rgb v = toDisplay(light, {.exposure_stops = 10, .filmic = filmic});
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(v[c], 0);
        EXPECT_LE(v[c], 1);
      }
    }
  }
}

TEST(Tone, BackgroundShowsThroughAndIsNotExposed) {
  Film film(3, 1);
  PathSample miss, hit;
  hit.alpha = 1;
  hit.direct = Rgb(0.5f);
  film.add(0, 0, 0, miss);
  film.add(1, 0, 0, hit);
  film.add(2, 0, 0, hit);
  film.add(2, 0, 1, miss);
  const Pixels8 pixels = toPixels(film, {.exposure_stops = -1});
  ASSERT_EQ(pixels.channels, 3);
  ASSERT_EQ(pixels.bytes.size(), 9u);
  const auto byte = [](float linear) { return std::lround(toDisplay(Rgb(linear), {}).r * 255); };
  EXPECT_EQ(pixels.bytes[0], byte(0.18f));
  EXPECT_EQ(pixels.bytes[3], byte(0.25f));
  EXPECT_EQ(pixels.bytes[6], byte(0.125f + 0.09f));
}

}  // namespace
}  // namespace loomlight
