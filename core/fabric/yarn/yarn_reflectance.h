#pragma once

#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The three numbers that give a thick mass of these fibres the colour that it has in daylight by all that is known of
/// its absorption, 1/mm: what is not known in bands is as it is.
Rgb absorptionOfPrimaries(const Fibre& fibre);

/// How a fibre looks in a thick mass: linear reflectance.
Rgb fibreReflectance(const Fibre& fibre);

/// How a yarn of the fabric looks in a thick mass, from the absorption of its fibres: linear reflectance.
Rgb yarnReflectance(const Fabric& fabric, const Yarn& yarn);

/// How each yarn of the fabric looks in a thick mass, from the absorption of its fibres: linear reflectance.
std::vector<Rgb> yarnReflectances(const Fabric& fabric);

}  // namespace loomlight
