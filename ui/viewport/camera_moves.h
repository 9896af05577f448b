#pragma once

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// What the mouse does to a camera. Pure; dx and dy in pixels, right and down, of a viewport `height` pixels high.
Camera orbited(const Camera& camera, double dx, double dy);
Camera panned(const Camera& camera, double dx, double dy, int height);
/// Wheel clicks towards the cloth; what lies under the pointer, (x, y) pixels from the centre, stays there.
Camera zoomed(const Camera& camera, double clicks, double x, double y, int height);
/// Whence a cloth is looked at by one key: straight from above, aslant as on a table before one, and along it, where
/// its relief and its sheen show.
enum class Viewpoint { above, aslant, grazing };
/// Turns about what the camera looks at; picks go up the screen.
Camera turnedTo(const Camera& camera, Viewpoint viewpoint);
/// From as far as shows a millimetre of cloth as so many pixels of a picture `height` pixels high.
Camera atScale(const Camera& camera, int height, double pixels_per_mm);
/// Straight from above on a flat piece about the middle of the scene, all of it. `aspect`: of the picture.
Camera aboveFlat(const Camera& camera, double width_mm, double height_mm, double aspect);
/// A ball around a mesh.
struct MeshExtent {
  glm::dvec3 centre_mm{0.0};
  double radius_mm = 50;
};
/// Whether it takes the drape's mesh to say how large it is.
bool hasOwnExtent(const Drape& drape);
/// Keeps the direction and shows the whole drape. `mesh`: of a drape that has its own extent.
Camera fitted(const Camera& camera, const Drape& drape, double aspect, const MeshExtent& mesh);

}  // namespace loomlight
