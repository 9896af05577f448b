#include "render/display/raster.h"

namespace loomlight {

Raster rasterOf(const Pixels8& pixels) {
  Raster raster{pixels.width, pixels.height, {}};
  const auto channels = static_cast<size_t>(pixels.channels);
  raster.pixels.reserve(pixels.bytes.size() / channels);
  for (size_t i = 0; i + channels <= pixels.bytes.size(); i += channels) {
    const int alpha = channels == 4 ? pixels.bytes[i + 3] : 255;
    const auto over = [&](size_t c) {
      return static_cast<uint8_t>((pixels.bytes[i + c] * alpha + 255 * (255 - alpha) + 127) / 255);
    };
    raster.pixels.push_back({over(0), over(1), over(2)});
  }
  return raster;
}

}  // namespace loomlight
