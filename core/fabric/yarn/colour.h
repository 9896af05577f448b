#pragma once

#include "core/base/spectrum.h"
#include "core/base/units.h"

namespace loomlight {

/// The absorption that gives a thick, dense mass of fibres the wanted colour, per mm inside the fibre, and back. Chiang
/// et al. 2016 fitted this to multiple scattering among hairs; `colour` is linear reflectance per channel. Measured
/// against walks in slabs it is good within some 6 %, for sheets that light comes through the cloth gets darker than
/// wanted; so it is where a designer starts, not a promise. Reflectance is held to [1e-4, 1]; nothing is darker than
/// what the fibres' surfaces mirror, about 0.015. `azimuthalRoughness` as in Fibre.
Rgb absorptionFromColour(const Rgb& colour, double azimuthalRoughness, double radius_um);
Rgb colourFromAbsorption(const Rgb& absorption_per_mm, double azimuthalRoughness, double radius_um);
/// The same in each band.
Spectrum reflectanceFromAbsorption(const Spectrum& absorption_per_mm, double azimuthalRoughness, double radius_um);

}  // namespace loomlight
