#pragma once

#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

// What the editor and the command line ask of render/transport/colour_walks.h alike, so that both find the same dyes.

/// How many walks tell the colour of a cloth: a standard error of half a percent of it.
inline constexpr size_t kDyeWalks = 8192;

/// All that walks depend on: the fabric's colourPatch() without its dyes and its names.
Fabric undyedPatch(const Fabric& fabric);

/// Of every fibre, 1/mm.
std::vector<Rgb> absorptionsOf(const Fabric& fabric);

}  // namespace loomlight
