#include "app/bench/studies/accuracy_cloths.h"

#include "app/wardrobe/wardrobe.h"
#include "core/fabric/weave/structures.h"

namespace loomlight {
namespace {

struct Filament {
  double radius_um = 6.5;
  double roughness = 0.2;
  int fibres = 160;
  double packing = 0.5, flattening = 1, twist_per_m = 600;
};

/// Warp and weft of the same filament, in two colours.
Fabric filamentCloth(Weave weave, double ends_per_cm, double picks_per_cm, const Filament& filament, Rgb warp_per_mm,
                     Rgb weft_per_mm) {
  Fabric fabric;
  fabric.weave = std::move(weave);
  fabric.ends_per_cm = ends_per_cm;
  fabric.picks_per_cm = picks_per_cm;
  fabric.weftSequence = {1};
  fabric.fibres.assign(2, Fibre{});
  fabric.yarns.assign(2, Yarn{});
  for (int i = 0; i < 2; ++i) {
    Fibre& fibre = fabric.fibres[static_cast<size_t>(i)];
    fibre.radius_um = filament.radius_um;
    fibre.density_g_cm3 = 1.39;
    fibre.longitudinalRoughness = fibre.azimuthalRoughness = filament.roughness;
    fibre.absorption_per_mm = i == 0 ? warp_per_mm : weft_per_mm;
    Yarn& yarn = fabric.yarns[static_cast<size_t>(i)];
    yarn.fibre = i;
    yarn.fibresPerPly = filament.fibres;
    yarn.plyTwist_per_m = filament.twist_per_m;
    yarn.packing = filament.packing;
    yarn.flattening = filament.flattening;
  }
  return fabric;
}

/// Yarns that just touch (Peirce), dark against clear in red, clear against dark in blue.
Fabric plainFilament() {
  return filamentCloth(plainWeave(), 24.5, 24.5, {}, {38, 12, 1.2}, {0.9, 4.6, 23});
}

Fabric denseSatin() {
  const Filament fine{
      .radius_um = 6, .roughness = 0.25, .fibres = 80, .packing = 0.65, .flattening = 1.3, .twist_per_m = 300};
  return filamentCloth(satin(5, 2), 60, 40, fine, {3, 30, 20}, {0.2, 1, 9});
}

Fabric blackAndWhite() {
  return filamentCloth(plainWeave(), 24.5, 24.5, {}, Rgb(100), Rgb(0));
}

/// Half of its area is holes.
Fabric sheerSilk() {
  const Filament thread{
      .radius_um = 5.56, .roughness = 0.15, .fibres = 18, .packing = 0.7, .flattening = 1.1, .twist_per_m = 550};
  Fabric fabric = filamentCloth(plainWeave(), 48, 44, thread, {0.3, 1.6, 6}, {0.3, 1.6, 6});
  for (Yarn& yarn : fabric.yarns) {
    yarn.plies = 2;
    yarn.yarnTwist_per_m = 450;
  }
  return fabric;
}

/// Two-ply suiting, whose fibres wander and stand off.
Fabric spunWool() {
  const Filament staple{
      .radius_um = 9.5, .roughness = 0.3, .fibres = 45, .packing = 0.5, .flattening = 1.15, .twist_per_m = 650};
  Fabric fabric = filamentCloth(twill(2, 2), 28, 25, staple, {16, 12, 6}, {0.8, 1.4, 3});
  for (Yarn& yarn : fabric.yarns) {
    yarn.plies = 2;
    yarn.yarnTwist_per_m = 430;
    yarn.migration = 0.25;
    yarn.hairiness_per_mm = 5;
    yarn.hairLength_mm = 0.5;
  }
  for (Fibre& fibre : fabric.fibres) fibre.scaleTilt_deg = 2.5;
  return fabric;
}

Fabric reportsTwill() {
  const Filament polyester{.roughness = 0.18, .flattening = 1.1, .twist_per_m = 500};
  Fabric fabric = filamentCloth(twill(2, 2), 28, 28, polyester, {30, 12, 2}, {1.5, 0.5, 0.1});
  for (Yarn& yarn : fabric.yarns) yarn.layout = FibreLayout::random;
  return fabric;
}

}  // namespace

std::vector<BenchCloth> accuracyCloths() {
  return {{"plain filament", plainFilament()}, {"twill, laid at random", reportsTwill()},
          {"dense satin", denseSatin()},       {"sheer silk", sheerSilk()},
          {"spun wool", spunWool()},           {"black and white", blackAndWhite()}};
}

std::vector<BenchCloth> realCloths() {
  std::vector<BenchCloth> cloths;
  for (const auto& [name, file] :
       {std::pair{"linen", "linen"}, {"tropical wool", "tropical_wool"}, {"raw denim", "denim_raw"}})
    cloths.push_back({name, wardrobeFabric(file)});
  return cloths;
}

}  // namespace loomlight
