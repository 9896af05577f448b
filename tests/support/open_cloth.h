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

/// Cloth that is open, from straight above, so far away that pixels are wider than its openings and it fills the
/// picture.
inline Fabric farAndOpen() {
  Fabric far = openCloth();
  far.ends_per_cm = far.picks_per_cm = 10;
  far.drape.width_mm = far.drape.height_mm = 160;
  far.camera.elevation_deg = 90;
  far.camera.distance_mm = 240;  // in 32 rows a pixel is 2.6 mm high, as much as 2.6 threads
  return far;
}

}  // namespace loomlight::test
