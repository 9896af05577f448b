#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands/cloth_colour.h"
#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The fabric with the dyes that give this very construction the wanted colours, as the editor finds them; several at
/// once each as the others will be. A measured swatch that cannot be had is matched as nearly as can be under the
/// illuminant of this name (illuminantCalled()), for the observer of 10 degrees. Says on stdout what was reached, or
/// that it cannot be had. nullopt when stopped by Ctrl-C. Throws InputError for a lamp that there is not; and, starting
/// with `source`, for a fibre that the fabric does not have, that is named twice or that never lies on the face.
std::optional<Fabric> dyed(Fabric fabric, const std::vector<ClothColour>& wanted, const std::string& illuminant,
                           const std::string& source);

}  // namespace loomlight
