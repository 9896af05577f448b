#include "app/export/handover/side_pixels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loomlight {
namespace {

TEST(SidePixels, RotationsNeverJumpNearWarpAndWeft) {
  const auto at = [](double angle_deg) {
    return rotationOf({std::cos(angle_deg * kPi / 180), std::sin(angle_deg * kPi / 180)});
  };
  for (double angle = -40; angle < 130; angle += 5) {
    EXPECT_NEAR(at(angle), 0.5 + angle / 360, 1e-5) << angle;
    EXPECT_NEAR(at(angle + 180), at(angle), 1e-5) << "an axis has two ends";
  }
}

TEST(SidePixels, EveryConventionHasTheSameSlopes) {
  const float roughness = 0.5f, anisotropy = 0.6f;
  const float across = roughness * roughness, along = std::lerp(across, 1.0f, anisotropy * anisotropy);
  const DisneyGloss disney = disneyGloss(roughness, anisotropy), open = openPbrGloss(roughness, anisotropy);
  const float aspect = std::sqrt(1 - 0.9f * disney.anisotropy);
  EXPECT_NEAR(disney.roughness * disney.roughness / aspect, along, 1e-5);
  EXPECT_NEAR(disney.roughness * disney.roughness * aspect, across, 1e-5);
  const float inverse = 1 - open.anisotropy;
  const float first = open.roughness * open.roughness * std::sqrt(2 / (1 + inverse * inverse));
  EXPECT_NEAR(first, along, 1e-5);
  EXPECT_NEAR(first * inverse, across, 1e-5);
}

/// (1 - cos)^5 of the angle between light and half vector sends back about 2 % of all light, Charlie's sheen over 10 %.
TEST(SidePixels, DisneysSheenIsAsBrightAsGltfs) {
  Principled surface;
  EXPECT_EQ(disneySheen(surface).value, 0);
  for (const float roughness : {0.3f, 0.6f, 1.0f}) {
    constexpr float kColour = 0.01f;
    surface.sheenColour = Rgb(kColour);
    surface.sheenRoughness = roughness;
    const SheenAlbedo charlie(roughness);
    double squares = 0;
    for (int i = 0; i < 64; ++i)
      squares += std::pow(kColour * charlie(static_cast<float>(std::sqrt((i + 0.5) / 64))), 2) / 64;
    const DisneySheen sheen = disneySheen(surface);
    EXPECT_GT(sheen.value, 3 * kColour) << roughness;
    EXPECT_LT(sheen.rmsError, std::sqrt(squares)) << "further off than none at all";
    surface.sheenColour = Rgb(2 * kColour);
    EXPECT_NEAR(disneySheen(surface).value, 2 * sheen.value, 1e-5);
    surface.sheenColour = Rgb(1);
    EXPECT_EQ(disneySheen(surface).value, 1) << "as much as there can be";
    EXPECT_GT(disneySheen(surface).rmsError, std::sqrt(squares)) << "which is stated to be too little";
  }
}

/// Albedo of a gloss of slope alpha in a view, over a grid of all directions of light.
template <class Fresnel>
double albedoOf(double alpha, double cosine, const Fresnel& fresnel) {
  constexpr int kCosines = 200, kAzimuths = 100;
  const glm::dvec3 out(std::sqrt(1 - cosine * cosine), 0, cosine);
  const auto reach = [alpha](double z) { return std::sqrt(alpha * alpha * (1 - z * z) + z * z); };
  double sum = 0;
  for (int i = 0; i < kCosines; ++i)
    for (int j = 0; j < kAzimuths; ++j) {
      const double z = (i + 0.5) / kCosines, sine = std::sqrt(1 - z * z), azimuth = kPi * (j + 0.5) / kAzimuths;
      const glm::dvec3 in(sine * std::cos(azimuth), sine * std::sin(azimuth), z), half = glm::normalize(in + out);
      const double slope = 1 - half.z * half.z + half.z * half.z * alpha * alpha;
      const double density = alpha * alpha / (kPi * slope * slope);
      const double masking = 0.5 / (z * reach(cosine) + cosine * reach(z));
      sum += z * density * masking * fresnel(glm::dot(half, out));
    }
  return sum * 2 * kPi / (kCosines * kAzimuths);
}

/// RMS over views of the albedo of a gloss with one Fresnel less that with another; slope 0.36.
template <class Fresnel, class Other>
double apart(const Fresnel& fresnel, const Other& other) {
  double squares = 0;
  for (int i = 0; i < 16; ++i) {
    const double cosine = std::sqrt((i + 0.5) / 16);
    squares += std::pow(albedoOf(0.36, cosine, fresnel) - albedoOf(0.36, cosine, other), 2) / 16;
  }
  return std::sqrt(squares);
}
double schlick(double normal, double cosine) {
  return normal + (1 - normal) * std::pow(1 - cosine, 5);
}
/// By Snell's law, from the angles on both sides.
double fresnel(double normal, double cosine) {
  const double index = (1 + std::sqrt(normal)) / (1 - std::sqrt(normal));
  const double angle = std::acos(cosine), inside = std::asin(std::sin(angle) / index);
  const double across = std::sin(angle - inside) / std::sin(angle + inside);
  const double along = std::tan(angle - inside) / std::tan(angle + inside);
  return 0.5 * (across * across + along * along);
}

TEST(SidePixels, GlossIsAsBrightInOtherModelsAsInGltfs) {
  Principled surface;
  surface.roughness = 0.6f;
  EXPECT_NEAR(disneySpecular(surface).value, 0.5, 1e-3) << "glass is one and the same";
  EXPECT_LT(disneySpecular(surface).rmsError, 1e-4);
  for (const float specular : {0.3f, 0.8f}) {
    SCOPED_TRACE(specular);
    surface.specular = specular;
    const auto gltf = [specular](double cosine) { return specular * schlick(0.04, cosine); };
    const auto expectNearest = [](const GlossStrength& found, const auto& off) {
      EXPECT_NEAR(found.rmsError, off(found.value), 0.1 * found.rmsError);
      for (const double by : {-0.1, 0.1}) {
        const double other = std::max(0.0, found.value + by);
        EXPECT_LE(off(found.value), off(other) + 1e-6) << other;
      }
    };
    expectNearest(openPbrSpecular(surface), [&](double value) {
      return apart(gltf, [value](double cosine) { return fresnel(0.04 * value, cosine); });
    });
    expectNearest(disneySpecular(surface), [&](double value) {
      return apart(gltf, [value](double cosine) { return schlick(0.08 * value, cosine); });
    });
  }
  surface.specular = 0.1f;
  EXPECT_NEAR(disneySpecular(surface).value, 0, 1e-3) << "less than that it cannot mirror";
  EXPECT_GT(disneySpecular(surface).rmsError, 0.01);
  EXPECT_GT(openPbrSpecular(surface).value, 0.01);
}

TEST(SidePixels, SplitLightIsTheLightThatWasSplit) {
  const Rgb reflected(0.3f, 0.2f, 0.1f), transmitted(0.2f, 0.3f, 0.05f);
  const SplitColour split = splitColour(reflected, transmitted);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(split.base[c] * (1 - split.share), reflected[c], 1e-6);
    EXPECT_NEAR(split.through[c] * split.share, transmitted[c], 1e-6);
  }
}

}  // namespace
}  // namespace loomlight
