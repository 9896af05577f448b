#pragma once

#include "core/base/units.h"

namespace loomlight {

/// Radiance of a black body at a wavelength, in units of its own (Planck's law).
double planck(double nm, double kelvin);

/// CIE 1931 colour matching functions as the Gaussians of Wyman, Sloan and Shirley (JCGT 2013).
glm::dvec3 colourMatching(double nm);

/// CIE XYZ to linear Rec. 709 (IEC 61966-2-1). Colours outside of the gamut lose their negative part.
Rgb rgbFromXyz(glm::vec3 xyz);

/// What tints white light like a black body: the ratio of its colour to that of one of 6500 K, in linear Rec. 709, of
/// luminance 1. All channels are positive from 2000 K on.
Rgb blackBodyTint(double kelvin);

}  // namespace loomlight
