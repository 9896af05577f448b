#pragma once

#include "core/fabric/model/fabric.h"
#include "render/film/image.h"

namespace loomlight {

// Places to look at cloth in, as lat-long images (R, G, B) that EnvironmentLight reads. Each lights white paper that
// lies on the table to radiance 1. Neutral: D65 is white. Their middle column lies in the direction of the azimuth.

/// The standard overcast sky (CIE 1955: three times as bright at the zenith as at the horizon) over grass of albedo
/// 0.2.
Image overcastSky();
/// A pale room with one large window.
Image windowedRoom();
/// A light booth as dyers judge colours in (ASTM D1729): grey, lit from above, open to the front.
Image lightBooth();

}  // namespace loomlight
