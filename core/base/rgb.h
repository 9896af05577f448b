#pragma once

#include <cmath>

#include "core/base/units.h"

namespace loomlight {

/// Luminance of linear light with the primaries and the white of Rec. 709 (ITU-R BT.709): 1 of white light of
/// radiance 1.
template <class Real>
Real luminance(const glm::vec<3, Real>& linear) {
  return Real(0.2126) * linear.r + Real(0.7152) * linear.g + Real(0.0722) * linear.b;
}

/// sRGB (IEC 61966-2-1) from and to linear light, channels in [0, 1]: what displays and colour pickers show.
inline float encodeSrgb(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}
inline float decodeSrgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}
inline Rgb srgbFromLinear(const Rgb& linear) {
  return {encodeSrgb(linear.r), encodeSrgb(linear.g), encodeSrgb(linear.b)};
}
/// The same of any light: what is beyond the gamut is cut off.
inline Rgb clippedSrgbFromLinear(const Rgb& linear) {
  return srgbFromLinear(glm::clamp(linear, Rgb(0.0f), Rgb(1.0f)));
}
inline Rgb linearFromSrgb(const Rgb& encoded) {
  return {decodeSrgb(encoded.r), decodeSrgb(encoded.g), decodeSrgb(encoded.b)};
}

}  // namespace loomlight
