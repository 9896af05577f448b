#pragma once

#include <string>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Files that programs of jacquard looms read: bitmaps of one bit a crossing, uncompressed, one row a pick and one
/// column an end or hook. They are drawn as point paper is: the first pick is the lowest row, the first end the left
/// column, and black is an end that is raised. Their resolution is that of the sett, so that they print at its ratio.

/// Baseline TIFF 6.0: rows from the top, the last pick first; a bit that is set is black.
std::string tiffOf(const Fabric& fabric);
/// Windows BMP of version 3: rows from the bottom, the first pick first; colour 0 is white, colour 1 black.
std::string bmpOf(const Fabric& fabric);

}  // namespace loomlight
