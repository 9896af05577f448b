#pragma once

#include <cmath>
#include <cstddef>

#include "render/film/image.h"
#include "render/light/lat_long.h"
#include "render/light/lighting.h"

namespace loomlight::test {

/// What can be seen of a light, at the centres of pixels: a lat-long picture (R, G, B; width x width / 2) that
/// EnvironmentLight reads back with azimuth 0. A sun smaller than a pixel is mostly not in it.
inline Image surroundings(const Light& light, int width) {
  const Lighting lighting(light, glm::vec3(0));
  Image image;
  image.width = width;
  image.height = width / 2;
  for (const char* name : {"R", "G", "B"}) image.add(name);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto cosTheta = static_cast<float>(std::cos(kPi * (y + 0.5) / image.height));
      const Rgb radiance =
          lighting.escape(latLongDirection((static_cast<float>(x) + 0.5f) / static_cast<float>(width), cosTheta));
      const size_t at = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
      for (int c = 0; c < 3; ++c) image.channels[static_cast<size_t>(c)].values[at] = radiance[c];
    }
  return image;
}

}  // namespace loomlight::test
