#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/export/handover/textures.h"

namespace loomlight {

/// What was fitted to a side, how far it is from what was measured, and what the pictures hold: in the sidecar, and
/// wherever a format has room for a program's own words.
nlohmann::ordered_json sideJson(const DigitalSide& side, const SideTextures& textures);

}  // namespace loomlight
