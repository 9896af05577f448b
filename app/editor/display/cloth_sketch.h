#pragma once

#include "core/fabric/model/fabric.h"
#include "render/film/image.h"

namespace loomlight {

/// What a designer sees of a cloth in the place of its picture until light has been traced: its draft in the colours of
/// its yarns' dyes, of the size that its RenderSettings say; of one yarn alone a strand of its colour. It takes some
/// milliseconds.
Pixels8 clothSketch(const Fabric& fabric);

}  // namespace loomlight
