#include "ui/yarn_colours.h"

#include "core/fabric/colour.h"
#include "ui/fields.h"

namespace loomlight {

std::vector<ImVec4> yarnColours(const Fabric& fabric) {
  std::vector<ImVec4> colours;
  colours.reserve(fabric.yarns.size());
  for (const Yarn& yarn : fabric.yarns) {
    const Fibre& fibre = fabric.fibres[static_cast<size_t>(yarn.fibre)];
    colours.push_back(
        toDisplayColour(colourFromAbsorption(fibre.absorption_per_mm, fibre.azimuthalRoughness, fibre.radius_um)));
  }
  return colours;
}

}  // namespace loomlight
