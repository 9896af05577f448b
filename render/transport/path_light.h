#pragma once

#include <array>
#include <span>

#include "core/base/units.h"
#include "render/optics/bcsdf.h"
#include "render/optics/polynomials.h"
#include "render/scene/colouring.h"

namespace loomlight {

/// Light that a path has met, as it would be if nothing were absorbed, and what colour hangs on beside the lengths
/// travelled: the fibre that sent a lamp's light onto the path, all modes at once. Light that the path has found by
/// itself has one mode, R, of which nothing is absorbed.
struct PathLight {
  Rgb radiance{0};  ///< with all weights of the path
  std::array<float, FibreBcsdf::kLobes> modes{1, 0, 0, 0};
  int material = 0;       ///< of that fibre
  float traverse_mm = 0;  ///< length of one traverse of it: mode p makes p of them
  float inside = 0;       ///< FibreBcsdf::Value::inside: the residual makes 3, 4, ... in a geometric series
};

namespace path_light_detail {

/// exp(-x), x >= 0. The one exponential by which paths get their colour: traced and recoloured pictures are equal
/// because it is.
inline Rgb attenuation(Rgb x) {
  const Float32x4 e = optics::exponential(Float32x4{-x.r, -x.g, -x.b, 0});
  return {e[0], e[1], e[2]};
}

}  // namespace path_light_detail

/// exp(-sum sigma_k L_k): what is left of light after these lengths inside the fibres of each material.
inline Rgb attenuation(std::span<const Rgb> absorption_per_mm, std::span<const float> lengths_mm) {
  Rgb exponent(0.0f);
  for (size_t k = 0; k < lengths_mm.size(); ++k) exponent += absorption_per_mm[k] * lengths_mm[k];
  return path_light_detail::attenuation(exponent);
}

namespace path_light_detail {

/// What all modes of a fibre send on together, of which this much is left after one traverse: of primaries, or of four
/// bands side by side.
template <class Channels>
Channels sentOn(const PathLight& light, const Channels& traverse) {
  const Channels residual = traverse * traverse * traverse * (1.0f - light.inside) / (1.0f - light.inside * traverse);
  return light.modes[0] + traverse * (light.modes[1] + traverse * light.modes[2]) + residual * light.modes[3];
}

/// The colour of light in primaries of which the bands are dimmed too.
Rgb colourInBands(const Rgb& primaries, const PathLight& light, std::span<const float> lengths_mm,
                  const Colouring& colouring);

}  // namespace path_light_detail

/// What is left in each band of light that has gone these lengths inside the fibres of each material, 1 at first.
Spectrum leftInBands(std::span<const float> lengths_mm, const Colouring& colouring);

/// The colour that light brings to the eye along a path that has travelled these lengths; one of each per material. In
/// primaries it takes two exponentials of four numbers; where materials are known in bands, 9 or 18 more.
inline Rgb colourOf(const PathLight& light, std::span<const float> lengths_mm, const Colouring& colouring) {
  const std::vector<Rgb>& absorption_per_mm = colouring.primaries_per_mm;
  const Rgb arriving = light.radiance * attenuation(absorption_per_mm, lengths_mm);
  const auto material = static_cast<size_t>(light.material);
  Rgb primaries = arriving;
  if (light.traverse_mm == 0)
    primaries *= light.modes[0];
  else if (!colouring.isSpectral(material))
    primaries *= path_light_detail::sentOn(
        light, path_light_detail::attenuation(absorption_per_mm[material] * light.traverse_mm));
  if (colouring.isSpectral()) return path_light_detail::colourInBands(primaries, light, lengths_mm, colouring);
  return colouring.eye.whole ? *colouring.eye.whole * primaries : primaries;
}

}  // namespace loomlight
