#pragma once

#include "core/fabric/weave/picture_weave.h"
#include "render/film/image.h"

namespace loomlight {

/// On white where it is transparent, as a picture is seen on paper.
Raster rasterOf(const Pixels8& pixels);

}  // namespace loomlight
