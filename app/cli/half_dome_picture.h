#pragma once

#include <string>

#include "render/colour/tone.h"
#include "render/film/image.h"
#include "render/transport/half_dome.h"

namespace loomlight {

/// A half-dome seen from above: the normal in the middle, inclination outwards, azimuth counter-clockwise from the
/// right. `side`: pixels; transparent beyond the rim.
Pixels8 halfDomePicture(const HalfDomeMeasure& measure, double paperRadiance, const Tone& tone, int side = 256);

/// Reflectance factors (1: as much as white paper) as R, G, B: a column for every azimuth, a row for every inclination.
Image halfDomeImage(const HalfDomeMeasure& measure, double paperRadiance);

/// Reflectance factors as text: azimuth_deg,inclination_deg,red,green,blue, one line a camera.
std::string halfDomeCsv(const HalfDomeMeasure& measure, double paperRadiance);

}  // namespace loomlight
