#include "core/fabric/yarn/colour_name.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/rgb.h"

namespace loomlight {
namespace {

struct NamedColour {
  std::string_view name;
  unsigned srgb;
};

constexpr NamedColour kNames[] = {
    {"white", 0xf7f7f5},       {"ivory", 0xf3ecd6},        {"ecru", 0xdcccae},       {"beige", 0xc8b088},
    {"silver grey", 0xb9bbbd}, {"stone", 0xa09a90},        {"grey", 0x808284},       {"anthracite", 0x3f4144},
    {"black", 0x141415},       {"rose", 0xe8a6b0},         {"pink", 0xe0559a},       {"salmon", 0xee8f78},
    {"red", 0xc8202c},         {"dark red", 0x861b24},     {"bordeaux", 0x521624},   {"orange", 0xe87a1e},
    {"rust", 0xa4481f},        {"terracotta", 0xbf6b4b},   {"camel", 0xa97b4b},      {"brown", 0x6a4326},
    {"dark brown", 0x3b2618},  {"cream yellow", 0xf2e19a}, {"yellow", 0xf0cc20},     {"gold", 0xc39a2e},
    {"mustard", 0xa9841c},     {"olive", 0x66682c},        {"khaki", 0x8f8a5e},      {"lime green", 0x9ac43c},
    {"green", 0x2d8a43},       {"dark green", 0x174a2b},   {"sage", 0x93a98a},       {"mint", 0xa6dcc0},
    {"turquoise", 0x2fb5b0},   {"petrol", 0x14545f},       {"light blue", 0xa3c4e4}, {"sky blue", 0x5f9fd8},
    {"blue", 0x2554b0},        {"denim blue", 0x44618c},   {"navy", 0x1a2547},       {"lilac", 0xb9a3d2},
    {"violet", 0x6a3f9c},      {"aubergine", 0x3d1f3c},    {"magenta", 0xb3246f},
};

/// Oklab (Ottosson 2020), in which distances are about as large as they look.
glm::vec3 oklab(const Rgb& c) {
  const float l = std::cbrt(0.4122214708f * c.r + 0.5363325363f * c.g + 0.0514459929f * c.b);
  const float m = std::cbrt(0.2119034982f * c.r + 0.6806995451f * c.g + 0.1073969566f * c.b);
  const float s = std::cbrt(0.0883024619f * c.r + 0.2817188376f * c.g + 0.6299787005f * c.b);
  return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
          1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
          0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

Rgb linearOf(unsigned srgb) {
  const auto channel = [srgb](int shift) { return static_cast<float>(srgb >> shift & 255) / 255.0f; };
  return linearFromSrgb(Rgb(channel(16), channel(8), channel(0)));
}

}  // namespace

std::string_view colourName(const Rgb& linear) {
  const glm::vec3 wanted = oklab(glm::clamp(linear, Rgb(0.0f), Rgb(1.0f)));
  const auto distance = [&](const NamedColour& named) { return glm::distance(oklab(linearOf(named.srgb)), wanted); };
  const auto nearest =
      std::min_element(std::begin(kNames), std::end(kNames),
                       [&](const NamedColour& a, const NamedColour& b) { return distance(a) < distance(b); });
  return nearest->name;
}

}  // namespace loomlight
