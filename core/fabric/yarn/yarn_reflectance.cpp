#include "core/fabric/yarn/yarn_reflectance.h"

#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/colour.h"

namespace loomlight {

Rgb fibreReflectance(const Fibre& fibre) {
  return colourFromAbsorption(fibre.absorption_per_mm, fibre.azimuthalRoughness, fibre.radius_um);
}

Rgb yarnReflectance(const Fabric& fabric, const Yarn& yarn) {
  Fibre fibre = fabric.fibres[static_cast<size_t>(yarn.fibre)];
  // Light in a blend goes through fibres of both kinds, so that their absorptions mix.
  if (yarn.blendFibre)
    fibre.absorption_per_mm =
        glm::mix(fibre.absorption_per_mm, fabric.fibres[static_cast<size_t>(*yarn.blendFibre)].absorption_per_mm,
                 static_cast<float>(blendNumberShare(yarn, fabric.fibres)));
  return fibreReflectance(fibre);
}

std::vector<Rgb> yarnReflectances(const Fabric& fabric) {
  std::vector<Rgb> reflectances;
  reflectances.reserve(fabric.yarns.size());
  for (const Yarn& yarn : fabric.yarns) reflectances.push_back(yarnReflectance(fabric, yarn));
  return reflectances;
}

}  // namespace loomlight
