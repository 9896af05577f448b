#include "render/metrics/heat_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/colour/colour_space.h"
#include "render/colour/tone.h"
#include "render/film/pixel_rect.h"

namespace loomlight {

Rgb heatColour(double value) {
  const double t = std::clamp(value, 0.0, 1.0);
  // A path through the sRGB gamut with room to spare: violet while dark, yellow while light, no colour at the ends.
  const double hue = (300 + 150 * t) * kPi / 180, chroma = 66 * std::sin(kPi * t);
  const glm::dvec3 linear = linearFromLab({100 * t, chroma * std::cos(hue), chroma * std::sin(hue)});
  return Rgb(glm::clamp(linear, 0.0, 1.0));
}

Pixels8 heatMap(const std::vector<float>& values, int width, int height, double range) {
  assert(values.size() == pixelCount(width, height) && range > 0);
  Pixels8 pixels{width, height, 3, {}};
  pixels.bytes.reserve(3 * values.size());
  for (const float value : values) {
    const Rgb colour = toDisplay(heatColour(value / range), plainTone());
    for (int i = 0; i < 3; ++i) pixels.bytes.push_back(byteOf(colour[i]));
  }
  return pixels;
}

}  // namespace loomlight
