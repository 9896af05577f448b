#pragma once

#include <imgui.h>

#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// How a fibre looks in a thick mass, for the display.
ImVec4 fibreColour(const Fibre& fibre);

/// How each yarn of the fabric looks in a thick mass, for swatches and drafts: display colours from the absorption of
/// its fibre.
std::vector<ImVec4> yarnColours(const Fabric& fabric);

}  // namespace loomlight
