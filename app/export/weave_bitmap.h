#pragma once

#include <string>

#include "core/fabric/model/fabric.h"

namespace loomlight {

// A weave as weavers draw it on point paper: one pixel a crossing, dark where the warp lies over, the first pick at the
// bottom, the first end at the left.

/// Any PNG; pixels darker than middle grey, as displayed, are warp over. Throws InputError naming the file.
Weave readWeaveBitmap(const std::string& file);
/// By the ending of its name: .png in shades of grey, or for looms .tif, .tiff and .bmp of one bit a pixel
/// (loom_bitmap.h). Throws InputError, also for another ending.
void writeWeaveBitmap(const std::string& file, const Fabric& fabric);

}  // namespace loomlight
