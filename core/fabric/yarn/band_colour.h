#pragma once

#include "core/base/spectrum.h"
#include "core/base/units.h"

namespace loomlight {

/// The colour, in linear Rec. 709, of what reflects so much in each band, in daylight (CIE D65, 2 degree observer): a
/// perfect diffuser is (1, 1, 1). Colours outside of the gamut have negative channels. It is what is shown of a
/// spectrum where there is no room for more than a chip; other lights and observers are render/colour's.
Rgb linearFromReflectance(const Spectrum& reflectance);

}  // namespace loomlight
