#include "app/export/handover/side_pixels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/export/handover/surface_samples.h"

namespace loomlight {
namespace {

/// Albedo of Disney's sheen of value 1, in a view at this cosine with the normal.
float disneySheenAlbedo(float cosine) {
  constexpr int kSquares = 24, kAzimuths = 24;
  const glm::vec3 out(std::sqrt(1 - cosine * cosine), 0, cosine);
  float sum = 0;
  for (int i = 0; i < kSquares; ++i)
    for (int j = 0; j < kAzimuths; ++j) {
      const float square = (static_cast<float>(i) + 0.5f) / kSquares;  // of the sine: equal projected solid angles
      const float azimuth = kPiF * (static_cast<float>(j) + 0.5f) / kAzimuths;  // the other half is its mirror image
      const float sine = std::sqrt(square);
      const glm::vec3 in(sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(1 - square));
      sum += std::pow(1 - glm::dot(in, glm::normalize(in + out)), 5.0f);
    }
  return kPiF * sum / (kSquares * kAzimuths);
}

constexpr int kViews = 32;  // of equal projected solid angle
constexpr float kGlass = 0.04f;

/// Schlick's Fresnel of a body that reflects so much at the normal, by the cosine with the half vector.
float schlick(float reflectance, float cosine) {
  return reflectance + (1 - reflectance) * std::pow(1 - cosine, 5.0f);
}

/// Fresnel's equations for the same.
float dielectric(float reflectance, float cosine) {
  const float root = std::sqrt(reflectance), index = (1 + root) / (1 - root);
  const float inside = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
  const float across = (cosine - index * inside) / (cosine + index * inside);
  const float along = (index * cosine - inside) / (index * cosine + inside);
  return 0.5f * (across * across + along * along);
}

/// A gloss as it is seen in a view: its normals that send light there, and how much each counts for in the albedo.
struct GlossView {
  std::vector<glm::vec2> normals;  ///< cosine of the view with the normal, weight
  template <class Fresnel>
  float albedo(const Fresnel& fresnel) const {
    float sum = 0;
    for (const glm::vec2& normal : normals) sum += normal.y * fresnel(normal.x);
    return sum;
  }
};

/// At this cosine of the view with the surface, with slopes that are alike every way.
GlossView glossView(float alpha, float cosine) {
  constexpr int kPlaces = 24, kAzimuths = 24;
  const glm::vec3 out(std::sqrt(1 - cosine * cosine), 0, cosine);
  const auto reach = [alpha](float z) { return std::sqrt(alpha * alpha * (1 - z * z) + z * z); };
  GlossView view;
  for (int i = 0; i < kPlaces; ++i)
    for (int j = 0; j < kAzimuths; ++j) {
      // Normals as dense as the area that GGX's cover; the other half of the azimuths is a mirror image.
      const float place = (static_cast<float>(i) + 0.5f) / kPlaces, slope = alpha * std::sqrt(place / (1 - place));
      const float azimuth = kPiF * (static_cast<float>(j) + 0.5f) / kAzimuths;
      const glm::vec3 half = glm::normalize(glm::vec3(slope * std::cos(azimuth), slope * std::sin(azimuth), 1));
      const float across = glm::dot(half, out), in = 2 * across * half.z - cosine;
      if (across <= 0 || in <= 0) continue;
      const float seen = 2 * in * across / (half.z * (in * reach(cosine) + cosine * reach(in)));
      view.normals.emplace_back(std::min(across, 1.0f), seen / (kPlaces * kAzimuths));
    }
  return view;
}

/// `fresnel`: of a strength, 0..1, and a cosine.
template <class Fresnel>
GlossStrength nearestGloss(const Principled& surface, const Fresnel& fresnel) {
  const glm::vec2 slopes = ggxSlopes({surface.roughness, surface.anisotropy});
  const float alpha = std::sqrt(slopes.x * slopes.y);
  std::vector<GlossView> views;
  std::vector<float> wanted;
  for (int i = 0; i < kViews; ++i) {
    const GlossView& view = views.emplace_back(glossView(alpha, std::sqrt((static_cast<float>(i) + 0.5f) / kViews)));
    wanted.push_back(surface.specular * view.albedo([](float cosine) { return schlick(kGlass, cosine); }));
  }
  const auto rms = [&](float strength) {
    float squares = 0;
    for (size_t i = 0; i < views.size(); ++i) {
      const float off = views[i].albedo([&](float cosine) { return fresnel(strength, cosine); }) - wanted[i];
      squares += off * off;
    }
    return std::sqrt(squares / kViews);
  };
  // The error has one valley: thirds of where it lies are left out, one after the other.
  float low = 0, high = 1;
  while (high - low > 1e-3f) {
    const float third = (high - low) / 3;
    if (rms(low + third) < rms(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  const float best = 0.5f * (low + high);
  return {best, rms(best)};
}

}  // namespace

SidePixel sidePixel(const DigitalSide& side, size_t pixel) {
  const PrincipledPoint at = surfacePoint(side.maps, side.roughnessScales, pixel);
  SidePixel out;
  out.reflected = glm::clamp(side.fit.reflectedWeight * at.reflected, 0.0f, 1.0f);
  out.transmitted = glm::clamp(side.fit.transmittedWeight * at.transmitted, 0.0f, 1.0f);
  out.opacity = side.maps.tile.opacity[pixel];
  out.normal = flattened(at.normal, side.fit.normalStrength);
  out.drawnOut = at.drawnOut;
  const PointGloss gloss = glossAt(side.fit.surface, at);
  out.roughness = gloss.roughness;
  out.anisotropy = gloss.anisotropy;
  return out;
}

float rotationOf(glm::vec2 drawnOut) {
  constexpr auto kTurn = static_cast<float>(2 * kPi);
  float turns = std::atan2(drawnOut.y, drawnOut.x) / kTurn;  // -0.5 to 0.5
  while (turns < 0.375f) turns += 0.5f;
  while (turns >= 0.875f) turns -= 0.5f;
  return turns;
}

DisneyGloss disneyGloss(float roughness, float anisotropy) {
  const glm::vec2 slopes = ggxSlopes({roughness, anisotropy});
  return {std::pow(slopes.x * slopes.y, 0.25f), std::min(1.0f, (1 - slopes.y / slopes.x) / 0.9f)};
}

DisneyGloss openPbrGloss(float roughness, float anisotropy) {
  const glm::vec2 slopes = ggxSlopes({roughness, anisotropy});
  const float ratio = slopes.y / slopes.x;
  return {std::sqrt(slopes.x * std::sqrt((1 + ratio * ratio) / 2)), 1 - ratio};
}

GlossStrength disneySpecular(const Principled& surface) {
  return nearestGloss(surface, [](float value, float cosine) { return schlick(2 * kGlass * value, cosine); });
}

GlossStrength openPbrSpecular(const Principled& surface) {
  return nearestGloss(surface, [](float value, float cosine) { return dielectric(kGlass * value, cosine); });
}

DisneySheen disneySheen(const Principled& surface) {
  const SheenAlbedo charlie(surface.sheenRoughness);
  const Rgb& colour = surface.sheenColour;
  const float mean = (colour.r + colour.g + colour.b) / 3, square = glm::dot(colour, colour) / 3;
  float products = 0, disneySquares = 0, charlieSquares = 0;
  for (int i = 0; i < kViews; ++i) {
    const float cosine = std::sqrt((static_cast<float>(i) + 0.5f) / kViews);
    const float is = disneySheenAlbedo(cosine), wanted = charlie(cosine);
    products += is * wanted / kViews;
    disneySquares += is * is / kViews;
    charlieSquares += wanted * wanted / kViews;
  }
  DisneySheen sheen;
  sheen.value = std::clamp(mean * products / disneySquares, 0.0f, 1.0f);
  const float errors =
      square * charlieSquares - 2 * sheen.value * mean * products + sheen.value * sheen.value * disneySquares;
  sheen.rmsError = std::sqrt(std::max(0.0f, errors));
  return sheen;
}

SplitColour splitColour(const Rgb& reflected, const Rgb& transmitted) {
  SplitColour split;
  split.share = std::min(0.99f, std::max({transmitted.r, transmitted.g, transmitted.b}));
  if (split.share > 0) split.through = glm::min(Rgb(1), transmitted / split.share);
  split.base = glm::min(Rgb(1), reflected / (1 - split.share));
  return split;
}

}  // namespace loomlight
