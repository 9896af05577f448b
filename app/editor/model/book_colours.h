#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/palette/palette.h"
#include "core/fabric/swatch/measured_swatch.h"
#include "ui/inspector/colour_book.h"

namespace loomlight {

/// How a colour of a palette looks in daylight on a display: of a reflectance or of CIELAB, brought from the white that
/// it is meant for to D65 (Bradford); else what it says itself.
BookColour bookColour(const NamedColour& colour);

ColourBook colourBook(const Palette& palette);

/// What a file of colours is good for: one measured swatch to be matched, or else a palette to choose from.
struct ColourFile {
  std::optional<MeasuredSwatch> swatch;
  Palette palette;
  std::vector<std::string> remarks;  ///< sentences
};

/// Reads a palette or measured swatches. Throws InputError.
ColourFile readColourFile(const std::string& file);

}  // namespace loomlight
