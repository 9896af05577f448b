#pragma once

#include "render/colour/tone.h"
#include "render/display/frame.h"
#include "render/film/image.h"

namespace loomlight {

/// A frame as it was traced, in the colours of the display; three channels.
Pixels8 displayPicture(const Frame& frame, const Tone& tone);

/// Where two pictures differ: each channel's distance, four times as bright, of means over 3 x 3 pixels, as noise is no
/// difference; what is finer than that is not seen. Of the size of the first. The second is as high and in the middle;
/// grey beside it where it is narrower.
Pixels8 differencePicture(const Pixels8& first, const Pixels8& second);

}  // namespace loomlight
