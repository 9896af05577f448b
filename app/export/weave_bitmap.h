#pragma once

#include <string>

#include "core/fabric/model/weave.h"

namespace loomlight {

// A weave as weavers draw it on point paper: one pixel a crossing, dark where the warp lies over, the first pick at the
// bottom, the first end at the left.

/// Any PNG; pixels darker than middle grey, as displayed, are warp over. Throws InputError naming the file.
Weave readWeaveBitmap(const std::string& file);
void writeWeaveBitmap(const std::string& file, const Weave& weave);

}  // namespace loomlight
