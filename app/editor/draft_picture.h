#pragma once

#include "core/fabric/fabric.h"
#include "render/film/image.h"

namespace loomlight {

/// The drawdown in the colours of its yarns, `side` pixels a side and three channels: some repeats of a small one, the
/// whole of a large one, of which each pixel shows the mean of a few crossings. A cloth of one colour is drawn as point
/// paper, warp dark.
Pixels8 draftPicture(const Fabric& fabric, int side);

}  // namespace loomlight
