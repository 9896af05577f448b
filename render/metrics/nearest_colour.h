#pragma once

#include "core/base/units.h"

namespace loomlight {

/// Of the colours between two, channel by channel, the one that looks nearest to `wanted` (CIEDE2000); `wanted` itself
/// where it lies between them. Cutting each channel off instead would make every pastel grey that is lighter than
/// `lightest`. Linear light, 1 is white paper; 0 < darkest <= lightest.
Rgb nearestColour(const Rgb& wanted, const Rgb& darkest, const Rgb& lightest);

}  // namespace loomlight
