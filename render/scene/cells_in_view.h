#pragma once

#include "core/fabric/weave/weave_edit.h"
#include "render/scene/scene.h"

namespace loomlight {

/// The crossings of the cloth that a picture of this width over height shows, all of them or a little more where the
/// drape is flat; on others those between what a grid of rays meets. None in view: the crossing in the middle.
CellRect cellsInView(const Camera& camera, double aspect, const ClothGeometry& geometry, const Shell& shell,
                     const ShellEntry& entry);

}  // namespace loomlight
