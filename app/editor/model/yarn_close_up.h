#pragma once

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A few diameters of one yarn of the fabric, lying free and straight under a sky, every fibre as it is: what a
/// magnifying glass shows. Its camera and settings are for a picture of that size.
Fabric yarnCloseUp(const Fabric& fabric, int yarn, int width, int height);

}  // namespace loomlight
