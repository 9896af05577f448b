#pragma once

#include "app/workers/frame.h"
#include "render/film/image.h"
#include "render/film/tone.h"

namespace loomlight {

/// A frame as it was traced, in the colours of the display; three channels.
Pixels8 displayPicture(const Frame& frame, const Tone& tone);

/// Where two pictures differ: each channel's distance, four times as bright. Of the size of the first; the second is
/// stretched over it.
Pixels8 differencePicture(const Pixels8& first, const Pixels8& second);

}  // namespace loomlight
