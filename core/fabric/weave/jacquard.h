#pragma once

#include "core/fabric/model/weave.h"

namespace loomlight {

/// A damask of `ends` x `picks` crossings, 8..Weave::kMaxSide each: the warp satin of the ground changes to weft sateen
/// in the figure, an ogee trellis around blossoms in half drop, with outlines and veins in twill. The figure fits the
/// repeat whatever its size; where both sides are multiples of 8 its structures join over the edge without a fault.
/// It is a function of its arguments alone. samples/jacquard.json is damaskJacquard(640, 640).
Weave damaskJacquard(int ends, int picks);

}  // namespace loomlight
