#pragma once

#include <array>

#include "core/base/spectrum.h"
#include "core/base/units.h"

namespace loomlight {

/// Spectra of red, green and blue.
using Primaries = std::array<Spectrum, 3>;

/// The smoothest reflectances of the three primaries of Rec. 709 under D65 and the observer of 2 degrees: nowhere
/// negative, and 1 together in every band. A reflectance mixed() of them has exactly that colour there, linear, and
/// lies in [0, 1] where its three numbers do.
const Primaries& colourPrimaries();

/// The same for light from the sky: power relative to that of D65 in each band, of daylight as the CIE makes it of
/// three components. A mixture has that colour, linear, for the observer of 2 degrees, and (1, 1, 1) is D65; colours
/// far from daylight's come out negative in some bands.
const Primaries& daylightPrimaries();

Spectrum mixed(const Primaries& primaries, const Rgb& amounts);

}  // namespace loomlight
