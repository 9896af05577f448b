#pragma once

#include <span>

#include "render/film/film.h"

namespace loomlight {

/// What is known of a picture's pixels beside their colour; row by row from the top left.
struct PixelTraits {
  std::span<const Film::Hit> hits;   ///< what the first sample met
  std::span<const float> variances;  ///< of the luminance; empty where it is unknown, as after one sample
};

/// For previews and for maps that are handed over, never for a picture that is measured: takes noise from a picture by
/// letting alike pixels exchange light (an edge-avoiding a-trous filter, Dammertz et al. 2010, in a symmetric form).
/// What one pixel gives another receives, so that the sum over the picture stays, and no colour is made that was not
/// there. Pixels on different yarns, or at different depths, exchange nothing, and others only as far as noise explains
/// how they differ: the less noise, the nearer the picture comes to what it was; without any, it is that. `rgba` is
/// linear, premultiplied.
void denoise(std::span<glm::vec4> rgba, const PixelTraits& traits, int width, int height, int threads);

}  // namespace loomlight
