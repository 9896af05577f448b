#pragma once

#include <string>

#include "core/base/spectrum.h"
#include "core/fabric/swatch/measured_swatch.h"

namespace loomlight {

/// The first measurement in a file; that there are more, and what was guessed of it, goes to stderr. Throws InputError.
MeasuredSwatch swatchFrom(const std::string& file);

/// Of the same, in the bands.
Spectrum reflectanceFrom(const std::string& file);

}  // namespace loomlight
