#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/fabric/weave/picture_weave.h"

namespace loomlight {

/// The colour that the cloth is to have where a fibre lies on top.
struct ClothColour {
  std::string fibre;   ///< its name, or its number from 1
  Rgb8 colour{};       ///< sRGB
  std::string swatch;  ///< file of a measurement, which the cloth is to reflect like in place of the colour; or empty
};

/// FIBRE=#RRGGBB, or FIBRE=FILE of a spectrophotometer. Throws UsageError naming `option`.
ClothColour parseClothColour(const std::string& option, const std::string& text);

/// The fabric with the dyes that give this very construction the wanted colours, as the editor finds them; several at
/// once each as the others will be. Says on stdout what was reached, or that it cannot be had. nullopt when stopped by
/// Ctrl-C. Throws InputError, starting with `source`, for a fibre that the fabric does not have, that is named twice or
/// that never lies on the face.
std::optional<Fabric> dyed(Fabric fabric, const std::vector<ClothColour>& wanted, const std::string& source);

}  // namespace loomlight
