#pragma once

#include <memory>

#include "render/scene/scene.h"

namespace loomlight::test {

/// A plain-woven white cotton swatch that fills most of the picture.
inline Fabric whiteCotton() {
  Fabric fabric;
  fabric.name = "white cotton";
  fabric.fibres[0].absorption_per_mm = Rgb(0.0f);
  fabric.yarns[0].count_tex = 20;
  fabric.ends_per_cm = 24;
  fabric.picks_per_cm = 22;
  fabric.drape.width_mm = 12;
  fabric.drape.height_mm = 12;
  fabric.camera.distance_mm = 25;
  fabric.render.resolution = 8;
  return fabric;
}

inline std::shared_ptr<const Scene> sceneOf(const Fabric& fabric) {
  return makeScene(std::make_shared<const Fabric>(fabric), Task{});
}

}  // namespace loomlight::test
