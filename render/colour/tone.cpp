#include "render/colour/tone.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/rgb.h"

namespace loomlight {
namespace {

constexpr float kKnee = 0.7f;

Rgb shoulder(Rgb c) {
  const float m = std::max({c.r, c.g, c.b});
  if (!(m > kKnee)) return c;
  const float bent = 1 - (1 - kKnee) * (1 - kKnee) / (m + 1 - 2 * kKnee);
  // Division before the product: m may be as large as floats go.
  return (c / m) * bent;
}

/// Of exposed and composited light.
Rgb encode(Rgb c, const Tone& tone) {
  // The order of the arguments makes NaN black; infinity is cut so that ratios of channels stay finite.
  for (int i = 0; i < 3; ++i) c[i] = std::min(std::max(0.0f, c[i]), 1e30f);
  if (tone.filmic) c = shoulder(c);
  for (int i = 0; i < 3; ++i) c[i] = std::min(encodeSrgb(std::min(c[i], 1.0f)), 1.0f);
  return c;
}

}  // namespace

Rgb toDisplay(Rgb linear, const Tone& tone) {
  return encode(linear * std::exp2(tone.exposure_stops), tone);
}

Pixels8 toPixels(const Film& film, const Tone& tone) {
  Pixels8 pixels{film.width(), film.height(), 3, {}};
  pixels.bytes.resize(3 * static_cast<size_t>(film.width()) * static_cast<size_t>(film.height()));
  const float exposure = std::exp2(tone.exposure_stops);
  parallelFor(static_cast<size_t>(film.height()), 0, [&](size_t row) {
    const int y = static_cast<int>(row);
    uint8_t* out = &pixels.bytes[3 * row * static_cast<size_t>(film.width())];
    for (int x = 0; x < film.width(); ++x) {
      const Rgb c = encode(film.mean(x, y) * exposure + (1 - film.alpha(x, y)) * tone.background, tone);
      for (int i = 0; i < 3; ++i) *out++ = static_cast<uint8_t>(c[i] * 255 + 0.5f);
    }
  });
  return pixels;
}

}  // namespace loomlight
