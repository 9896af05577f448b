#pragma once

#include <string>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The colours that the fabric's fibres have now, under a name.
Colourway colourwayOf(const Fabric& fabric, std::string name);

/// The fabric in other colours. Its construction stays, so that no voxel changes.
Fabric inColourway(Fabric fabric, const Colourway& colourway);

}  // namespace loomlight
