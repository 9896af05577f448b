#pragma once

#include <string>

#include "app/export/handover/digital_cloth.h"
#include "app/export/handover/textures.h"

namespace loomlight {

/// The cloth as a fabric of CLO in JSON. Experimental: CLO's makers describe the format in their kit for developers
/// alone, nobody has tried this file, and its keys are those that programs write which others steer CLO by: the name,
/// the composition, mass and thickness, and the front's base colour at its size.
std::string jfabText(const DigitalCloth& cloth, const SideTextures& front);

}  // namespace loomlight
