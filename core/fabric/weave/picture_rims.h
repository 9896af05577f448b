#pragma once

#include <vector>

#include "core/fabric/weave/picture_weave.h"

namespace loomlight {

/// What a pixel's colour says of the areas of a drawing.
enum class PixelKind : uint8_t {
  area,   ///< it is that of an area, as its neighbours' are
  rim,    ///< a mixture of the areas on both sides of an edge, which was drawn smooth
  alone,  ///< like none of its neighbours: a point, or where rims meet
};

/// Of every pixel.
std::vector<PixelKind> pixelKinds(const Raster& raster);

/// Gives each rim the number of that area beside it whose colour is nearest to its own. `numbers` of other pixels stay;
/// those of rims are used only where no area is near.
void takeRimsIntoNeighbours(const Raster& raster, const std::vector<Rgb8>& palette, std::vector<uint8_t>& numbers);

}  // namespace loomlight
