#pragma once

#include <vector>

#include "core/base/units.h"
#include "render/film/image.h"

namespace loomlight {

/// The colour of a value in [0, 1]: from black through violet, red and orange to a light yellow and white. CIELAB
/// lightness rises evenly with the value, so that equal steps look equal, and the order survives print in grey and any
/// colour blindness. Linear light.
Rgb heatColour(double value);

/// Values from 0 to `range` as colours, width * height, row by row from the top left; more than `range` is white.
Pixels8 heatMap(const std::vector<float>& values, int width, int height, double range);

}  // namespace loomlight
