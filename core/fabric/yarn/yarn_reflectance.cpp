#include "core/fabric/yarn/yarn_reflectance.h"

#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/band_colour.h"
#include "core/fabric/yarn/colour.h"

namespace loomlight {

Rgb absorptionOfPrimaries(const Fibre& fibre) {
  const Absorption& absorption = fibre.absorption_per_mm;
  if (!absorption.isSpectral()) return absorption.primaries;
  const Rgb shown =
      linearFromReflectance(reflectanceFromAbsorption(absorption.inBands(), fibre.azimuthalRoughness, fibre.radius_um));
  return absorption.primaries + absorptionFromColour(shown, fibre.azimuthalRoughness, fibre.radius_um);
}

Rgb fibreReflectance(const Fibre& fibre) {
  return colourFromAbsorption(absorptionOfPrimaries(fibre), fibre.azimuthalRoughness, fibre.radius_um);
}

Rgb yarnReflectance(const Fabric& fabric, const Yarn& yarn) {
  Fibre fibre = fabric.fibres[static_cast<size_t>(yarn.fibre)];
  // Light in a blend goes through fibres of both kinds, so that their absorptions mix.
  if (yarn.blendFibre)
    fibre.absorption_per_mm = glm::mix(absorptionOfPrimaries(fibre),
                                       absorptionOfPrimaries(fabric.fibres[static_cast<size_t>(*yarn.blendFibre)]),
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
