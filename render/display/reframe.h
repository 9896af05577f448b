#pragma once

#include "render/display/frame.h"

namespace loomlight {

/// A new picture of few samples, perhaps coarse, of a viewport of this size, with the pixels of an older, better one
/// that was of another size: the same cloth, seen by the same camera. That one is as high as the new one, and where it
/// is narrower it fades into it. While panels fold or a splitter is dragged, what was seen stays as clear as it was.
Frame reframed(const Frame& fresh, const Frame& old, int width, int height, int threads);

}  // namespace loomlight
