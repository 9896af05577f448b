#include "core/fabric/yarn/yarn_reflectance.h"

#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/colour.h"

namespace loomlight {

Rgb fibreReflectance(const Fibre& fibre) {
  return colourFromAbsorption(fibre.absorption_per_mm, fibre.azimuthalRoughness, fibre.radius_um);
}

std::vector<Rgb> yarnReflectances(const Fabric& fabric) {
  std::vector<Rgb> reflectances;
  reflectances.reserve(fabric.yarns.size());
  for (const Yarn& yarn : fabric.yarns) {
    // Light in a blend goes through fibres of both kinds, so that their absorptions mix.
    Fibre fibre = fabric.fibres[static_cast<size_t>(yarn.fibre)];
    if (yarn.blendFibre) {
      const auto share = static_cast<float>(blendNumberShare(yarn, fabric.fibres));
      fibre.absorption_per_mm = glm::mix(fibre.absorption_per_mm,
                                         fabric.fibres[static_cast<size_t>(*yarn.blendFibre)].absorption_per_mm, share);
    }
    reflectances.push_back(fibreReflectance(fibre));
  }
  return reflectances;
}

}  // namespace loomlight
