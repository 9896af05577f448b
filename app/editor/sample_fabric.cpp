#include "app/editor/sample_fabric.h"

namespace loomlight {
namespace {

Fibre dyedCotton(const char* name, Rgb absorption_per_mm) {
  Fibre fibre;
  fibre.name = name;
  fibre.radius_um = 6.5;
  fibre.density_g_cm3 = 1.52;
  fibre.refractiveIndex = 1.55;
  fibre.absorption_per_mm = absorption_per_mm;
  fibre.section = FibreSection::kidney;
  return fibre;
}

Yarn cottonYarn(const char* name, int fibre) {
  Yarn yarn;
  yarn.name = name;
  yarn.fibre = fibre;
  yarn.count_tex = 39.4;  // 30/2 Ne
  yarn.plies = 2;
  yarn.plyTwist_per_m = 780;
  yarn.yarnTwist_per_m = 520;
  yarn.flattening = 1.25;
  return yarn;
}

}  // namespace

Fabric sampleFabric() {
  Fabric fabric;
  fabric.name = "Blue twill";
  fabric.description = "A cotton 2/2 twill: indigo warp, lighter weft.";
  fabric.weave = Weave({{1, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 1}, {1, 0, 0, 1}});
  fabric.fibres = {dyedCotton("indigo cotton", Rgb(30.0f, 14.0f, 3.0f)),
                   dyedCotton("pale blue cotton", Rgb(4.0f, 2.0f, 0.6f))};
  fabric.yarns = {cottonYarn("Indigo warp", 0), cottonYarn("Pale weft", 1)};
  fabric.warpSequence = {0};
  fabric.weftSequence = {1};
  fabric.ends_per_cm = 22;
  fabric.picks_per_cm = 20;
  fabric.drape.width_mm = 12;
  fabric.drape.height_mm = 12;
  fabric.camera.distance_mm = 40;
  return fabric;
}

}  // namespace loomlight
