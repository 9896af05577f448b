#include "render/transport/dye_walks.h"

#include "render/transport/colour_walks.h"

namespace loomlight {

Fabric undyedPatch(const Fabric& fabric) {
  Fabric patch = colourPatch(fabric);
  patch.name.clear();
  patch.description.clear();
  patch.camera = Camera{};
  patch.draft.reset();
  patch.wif.reset();
  patch.colourways.clear();
  for (Fibre& fibre : patch.fibres) {
    fibre.name.clear();
    fibre.absorption_per_mm = Rgb(0.0f);
  }
  for (Yarn& yarn : patch.yarns) yarn.name.clear();
  return patch;
}

std::vector<Rgb> absorptionsOf(const Fabric& fabric) {
  std::vector<Rgb> absorptions;
  for (const Fibre& fibre : fabric.fibres) absorptions.push_back(fibre.absorption_per_mm);
  return absorptions;
}

}  // namespace loomlight
