#pragma once

#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// How a fibre looks in a thick mass: linear reflectance.
Rgb fibreReflectance(const Fibre& fibre);

/// How a yarn of the fabric looks in a thick mass, from the absorption of its fibres: linear reflectance.
Rgb yarnReflectance(const Fabric& fabric, const Yarn& yarn);

/// How each yarn of the fabric looks in a thick mass, from the absorption of its fibres: linear reflectance.
std::vector<Rgb> yarnReflectances(const Fabric& fabric);

}  // namespace loomlight
