#pragma once

#include "core/base/units.h"
#include "render/film/film.h"

namespace loomlight {

/// What display and PNG share: exposure in stops, then a shoulder that keeps mid-tones and hues, then sRGB encoding.
///
/// For a pixel with linear premultiplied radiance rgb and coverage a (shaders/display.frag computes the same):
///   c = max(rgb * 2^exposure_stops + (1 - a) * background, 0)
///   filmic:  m = max(c.r, c.g, c.b);  if (m > k) c *= (1 - (1 - k)^2 / (m + 1 - 2 k)) / m,  with k = 0.7
///   else:    c = min(c, 1)
///   v <= 0.0031308 ? 12.92 v : 1.055 v^(1/2.4) - 0.055,  for each channel
/// The shoulder is the identity up to k, goes on with the same slope, and nears 1 only at infinity: middle grey stays
/// what it is, radiance 1 displays as 0.85 (sRGB 237 of 255), 4 as 0.975. It scales all channels by one factor, so
/// hue and saturation stay. The background is not exposed, so that the surround of the cloth stays when it changes.
struct Tone {
  float exposure_stops = 0;
  bool filmic = true;     ///< false: plain sRGB, clipped
  Rgb background{0.18f};  ///< linear; behind the cloth, where alpha < 1
  friend bool operator==(const Tone&, const Tone&) = default;
};
/// For judging colour: light as it is, up to white, which is radiance 1: that of a perfect diffuser in light of
/// intensity 1. What is brighter is cut off.
inline Tone plainTone() {
  return {.exposure_stops = 0, .filmic = false};
}

/// Of an opaque pixel: in [0, 1], sRGB-encoded.
Rgb toDisplay(Rgb linear, const Tone& tone);
/// Three channels, composited over the background.
Pixels8 toPixels(const Film& film, const Tone& tone);

}  // namespace loomlight
