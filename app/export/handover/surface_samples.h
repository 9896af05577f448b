#pragma once

#include <vector>

#include "app/export/handover/side_maps.h"
#include "app/export/handover/surface_fit.h"

namespace loomlight {

/// How rough each yarn's highlights are beside the mean of the side: the root of its fibres' longitudinal roughness
/// over the mean of all that is seen, as GGX's slopes go with the square of what renderers call roughness.
std::vector<float> roughnessScales(const SideMaps& side, const Fabric& fabric);

/// What a pixel is as a surface: its highlight is drawn out across its fibres. `scales`: roughnessScales().
PrincipledPoint surfacePoint(const SideMaps& side, const std::vector<float>& scales, size_t pixel);

/// At most `count` pixels, spread evenly over the tile, whose colours are scaled so that their mean is that of all.
std::vector<SurfaceSample> surfaceSamples(const SideMaps& side, const Fabric& fabric, int count);

/// Mean over the tile, holes counted as black.
struct MeanColours {
  Rgb reflected{0}, transmitted{0};
};
MeanColours meanColours(const SideMaps& side);

}  // namespace loomlight
