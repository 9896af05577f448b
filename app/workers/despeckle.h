#pragma once

#include <span>

#include "core/base/units.h"

namespace loomlight {

/// For previews of few samples only, never for a saved picture: holds every pixel to at most `limit` times the median of
/// its 3 x 3 neighbourhood, so that single lucky paths to the sun do not stand as blocks in a coarse picture. Hue and
/// alpha stay. `rgba` is linear, premultiplied, row by row.
void despeckle(std::span<glm::vec4> rgba, int width, int height, float limit);

}  // namespace loomlight
