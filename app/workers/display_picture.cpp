#include "app/workers/display_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace loomlight {

Pixels8 displayPicture(const Frame& frame, const Tone& tone) {
  Pixels8 pixels{frame.width, frame.height, 3, {}};
  pixels.bytes.reserve(3 * frame.rgba.size());
  // The background is not exposed, and toDisplay() exposes all.
  const float unexposed = std::exp2(-tone.exposure_stops);
  for (const glm::vec4& pixel : frame.rgba) {
    const Rgb colour = toDisplay(Rgb(pixel) + (1 - pixel.a) * unexposed * tone.background, tone);
    for (int c = 0; c < 3; ++c)
      pixels.bytes.push_back(static_cast<uint8_t>(std::lround(255 * std::clamp(colour[c], 0.0f, 1.0f))));
  }
  return pixels;
}

Pixels8 differencePicture(const Pixels8& first, const Pixels8& second) {
  assert(first.channels == 3 && second.channels == 3);
  constexpr int kGain = 4;
  Pixels8 difference{first.width, first.height, 3, std::vector<uint8_t>(first.bytes.size())};
  for (int y = 0; y < first.height; ++y)
    for (int x = 0; x < first.width; ++x) {
      const int sx = x * second.width / first.width, sy = y * second.height / first.height;
      const size_t at = 3 * (static_cast<size_t>(y) * static_cast<size_t>(first.width) + static_cast<size_t>(x));
      const size_t there = 3 * (static_cast<size_t>(sy) * static_cast<size_t>(second.width) + static_cast<size_t>(sx));
      for (size_t c = 0; c < 3; ++c)
        difference.bytes[at + c] = static_cast<uint8_t>(
            std::min(255, kGain * std::abs(int{first.bytes[at + c]} - int{second.bytes[there + c]})));
    }
  return difference;
}

}  // namespace loomlight
