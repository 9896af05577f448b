#pragma once

#include <string>

#include "core/fabric/palette/palette.h"

namespace loomlight {

/// The colour that the cloth is to have where a fibre lies on top.
struct ClothColour {
  std::string fibre;   ///< its name, or its number from 1
  NamedColour colour;  ///< linear, or CIELAB in daylight (D65)
  std::string
      swatch;  ///< a measurement (swatchFrom()), which the cloth is to reflect like in place of the colour; or empty
};

/// FIBRE=#RRGGBB, FIBRE=Lab L a b (colourFromCode()), or FIBRE=FILE or FIBRE=FILE:NAME of a spectrophotometer. Throws
/// UsageError naming `option`.
ClothColour parseClothColour(const std::string& option, const std::string& text);

}  // namespace loomlight
