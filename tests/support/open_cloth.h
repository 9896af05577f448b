#pragma once

#include "core/fabric/weave/structures.h"

namespace loomlight::test {

/// Coarse white fibres in an open twill, which are soon traced.
inline Fabric openCloth() {
  Fabric fabric;
  fabric.weave = twill(2, 1);
  fabric.ends_per_cm = 4;
  fabric.picks_per_cm = 5;
  fabric.yarns[0].fibresPerPly = 20;
  fabric.yarns[0].layout = FibreLayout::random;
  fabric.fibres[0].radius_um = 40;
  fabric.render.resolution = 1;
  return fabric;
}

}  // namespace loomlight::test
