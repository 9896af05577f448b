#pragma once

#include "core/fabric/model/fabric.h"
#include "core/fabric/weave/structures.h"

namespace loomlight::test {

/// Dark warp and white weft in a warp-faced twill: no side of it looks like the other, nor like its mirror image.
inline Fabric twoSidedCloth() {
  Fabric fabric;
  fabric.weave = twill(3, 1);
  fabric.ends_per_cm = 12;
  fabric.picks_per_cm = 10;
  fabric.yarns[0].fibresPerPly = 60;
  fabric.yarns[0].layout = FibreLayout::random;
  fabric.fibres[0].radius_um = 15;
  fabric.yarns.push_back(fabric.yarns[0]);
  fabric.yarns[1].fibre = 1;
  fabric.fibres.push_back(fabric.fibres[0]);
  fabric.fibres[0].absorption_per_mm = Rgb(60, 20, 5);
  fabric.weftSequence = {1};
  fabric.render.resolution = 2;
  fabric.render.samplesPerPixel = 32;
  return fabric;
}

}  // namespace loomlight::test
