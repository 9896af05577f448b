#pragma once

#include <span>

#include "core/base/units.h"

namespace loomlight {

/// For previews of few samples only, never for a saved picture: holds every pixel to at most `limit` times the median
/// of its 3 x 3 neighbourhood, so that single lucky paths to the sun do not glare. Hue and alpha stay. `rgba` is
/// linear, premultiplied, row by row.
void despeckle(std::span<glm::vec4> rgba, int width, int height, float limit);

/// For coarse previews only: every pixel becomes the mean of its 3 x 3 neighbourhood, weighted 1 2 1 both ways, so that
/// single noisy samples stretched over many pixels look like cloth out of focus rather than like tiles.
void soften(std::span<glm::vec4> rgba, int width, int height);

}  // namespace loomlight
