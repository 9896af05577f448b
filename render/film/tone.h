#pragma once

#include "core/base/units.h"
#include "render/film/film.h"

namespace loomlight {

/// What display and PNG share: exposure in stops, then a shoulder that keeps mid-tones and hues, then sRGB encoding.
/// The shader in shaders/ computes the same.
struct Tone {
  float exposure_stops = 0;
  bool filmic = true;              ///< false: plain sRGB, clipped
  Rgb background{0.18f};           ///< linear; behind the cloth, where alpha < 1
};
Rgb toDisplay(Rgb linear, const Tone& tone);     ///< in [0, 1], sRGB-encoded
Pixels8 toPixels(const Film& film, const Tone& tone);

}  // namespace loomlight
