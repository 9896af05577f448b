#pragma once

#include <span>

#include "core/fabric/model/fabric.h"
#include "render/film/image.h"

namespace loomlight {

/// The drawdown in the colours of its yarns, in three channels: along the longer side some repeats of a small one, the
/// whole of a large one, of which each pixel shows the mean of a few crossings. In a cloth of one colour
/// the warp is darker and the weft lighter, as on point paper. Crossings have the shape that the sett gives them.
/// `yarnColours`: linear, one for each.
Pixels8 draftPicture(const Fabric& fabric, std::span<const Rgb> yarnColours, int width, int height);

}  // namespace loomlight
