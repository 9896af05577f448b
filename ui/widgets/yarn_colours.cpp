#include "ui/widgets/yarn_colours.h"

#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/colour.h"
#include "ui/widgets/fields.h"

namespace loomlight {

ImVec4 fibreColour(const Fibre& fibre) {
  return toDisplayColour(colourFromAbsorption(fibre.absorption_per_mm, fibre.azimuthalRoughness, fibre.radius_um));
}

std::vector<ImVec4> yarnColours(const Fabric& fabric) {
  std::vector<ImVec4> colours;
  colours.reserve(fabric.yarns.size());
  for (const Yarn& yarn : fabric.yarns) {
    // Light in a blend goes through fibres of both kinds, so that their absorptions mix.
    Fibre fibre = fabric.fibres[static_cast<size_t>(yarn.fibre)];
    if (yarn.blendFibre) {
      const auto share = static_cast<float>(blendNumberShare(yarn, fabric.fibres));
      fibre.absorption_per_mm = glm::mix(fibre.absorption_per_mm,
                                         fabric.fibres[static_cast<size_t>(*yarn.blendFibre)].absorption_per_mm, share);
    }
    colours.push_back(fibreColour(fibre));
  }
  return colours;
}

}  // namespace loomlight
