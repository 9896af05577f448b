#pragma once

#include <string>

#include "core/fabric/yarn/cloth_part.h"

namespace loomlight {

/// What a fibre of the fabric is called once it is dyed anew: "silk, champagne" is silk then. A name that says no
/// colour stays.
std::string nameOnceDyed(const Fabric& fabric, int fibre);

/// A fabric that is readyToDye(), all fibres of whose part absorb so; they are called by what stays true of them.
Fabric dyedAlike(Fabric ready, const ClothPart& part, const Absorption& absorption);

}  // namespace loomlight
