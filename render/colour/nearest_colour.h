#pragma once

#include "core/base/units.h"

namespace loomlight {

/// Of the colours between two, channel by channel, the one that looks nearest to `wanted`; `wanted` itself where it
/// lies between them. Nearest by CIEDE2000 with kL = 2, as the textile trade judges: who cannot have a colour rather
/// has it darker than of another hue. It is the better end of two descents, from the colour cut off and from its hue as
/// light as can be had; far from all that can be had the formula may rank a grey a little nearer still, which is not
/// looked for. Linear light, 1 is white paper; 0 < darkest <= lightest.
Rgb nearestColour(const Rgb& wanted, const Rgb& darkest, const Rgb& lightest);

}  // namespace loomlight
