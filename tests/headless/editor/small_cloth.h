#pragma once

#include <string>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A cloth that a slow machine keeps up with: coarse fibres, a small flat piece, few voxels.
inline Fabric smallCloth(const std::string& name) {
  Fabric fabric;
  fabric.name = name;
  fabric.fibres[0].name = "coarse";
  fabric.fibres[0].radius_um = 20;
  fabric.drape.width_mm = fabric.drape.height_mm = 4;
  fabric.light.kind = LightKind::dome;
  fabric.camera.distance_mm = 64;  // hardly any of the picture, so that tracing it takes no time
  fabric.camera.elevation_deg = 75;
  fabric.render.resolution = 1;
  return fabric;
}

}  // namespace loomlight
