#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "render/film/image.h"

namespace loomlight::test {

/// A pixel of a picture of three channels.
using Pixel = std::array<uint8_t, 3>;

inline Pixel pixelAt(const Pixels8& picture, int x, int y) {
  const size_t at = 3 * (static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x));
  return {picture.bytes[at], picture.bytes[at + 1], picture.bytes[at + 2]};
}

/// Every colour of a picture, and how many pixels have it.
inline std::map<Pixel, int> coloursIn(const Pixels8& picture) {
  std::map<Pixel, int> counts;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) ++counts[pixelAt(picture, x, y)];
  return counts;
}

}  // namespace loomlight::test
