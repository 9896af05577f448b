#pragma once

#include "core/fabric/model/fabric.h"
#include "render/display/frame.h"

namespace loomlight {

/// A new picture of few samples, perhaps coarse, with the pixels of an older, better one of the whole viewport wherever
/// both show the same yarn at the same crossing. Both weaves are of one size. While a stroke is painted across the
/// weave, all that it does not touch stays as clear as it was, and all that it turns is seen at once, wherever the few
/// samples fell: the weaves of both pictures tell where that is. In `crowded` cloth (Fabric::crowding) yarns move aside
/// for what changes beside them.
Frame patched(Frame fresh, const Frame& old, const Weave& weaveNow, const Weave& weaveThen, bool crowded);

}  // namespace loomlight
