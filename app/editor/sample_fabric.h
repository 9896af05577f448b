#pragma once

#include "core/fabric/fabric.h"

namespace loomlight {

/// The cloth that a new editor opens on: a blue cotton 2/2 twill with a lighter weft.
Fabric sampleFabric();

}  // namespace loomlight
