#pragma once

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The cloth turned over like a page, about its warp: what was its back is its face, and its ends run the other way.
/// Of the weave alone; a draft that has made it is left out.
Fabric turnedOver(Fabric fabric);

/// The place of an end in the cloth that is turned over, and of one of that in the cloth as it was. Any integer.
constexpr int turnedEnd(int end) {
  return -1 - end;
}

}  // namespace loomlight
