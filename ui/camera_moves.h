#pragma once

#include "core/fabric/fabric.h"

namespace loomlight {

/// What the mouse does to a camera. Pure; dx and dy in pixels, right and down, of a viewport `height` pixels high.
Camera orbited(const Camera& camera, double dx, double dy);
Camera panned(const Camera& camera, double dx, double dy, int height);
/// Wheel clicks towards the cloth; what lies under the pointer, (x, y) pixels from the centre, stays there.
Camera zoomed(const Camera& camera, double clicks, double x, double y, int height);
/// Keeps the direction and shows the whole drape. A mesh's size is not known here: `meshRadius_mm` is.
Camera fitted(const Camera& camera, const Drape& drape, double aspect, double meshRadius_mm);

}  // namespace loomlight
