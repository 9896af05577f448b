#pragma once

#include "core/base/spectrum.h"
#include "render/colour/tristimulus.h"

namespace loomlight {

/// Of the reflectances between two, band by band, the one that looks nearest to `wanted`, by CIEDE2000 under the light
/// and for the observer of the weights; `wanted` itself where it lies between them. It is the better end of two
/// descents, from `wanted` cut off and from its hue as light as can be had, so it is never further than cutting off;
/// of two as near as an eye can tell it is the smoother.
/// 1 is a perfect diffuser; 0 < darkest <= lightest.
Spectrum nearestReflectance(const Spectrum& wanted, const Spectrum& darkest, const Spectrum& lightest,
                            const TristimulusWeights& weights);

}  // namespace loomlight
