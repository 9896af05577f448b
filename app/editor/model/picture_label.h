#pragma once

#include <string>

#include "render/film/image.h"

namespace loomlight {

/// What stands below a picture that is sent to somebody.
struct PictureLabel {
  bool scaleBar = false;
  std::string caption;

  bool isEmpty() const { return !scaleBar && caption.empty(); }
};

/// The longest of 1, 2, 5, 10... (times a power of ten) that is no longer than `longest`; longest > 0.
double roundLength(double longest);

/// The picture with a band below: a bar of a round length, and the caption, shortened to the room there is. Three
/// channels. `mm_per_pixel`: of the cloth, where the camera looks. An empty label leaves the picture as it is.
Pixels8 labelled(const Pixels8& picture, const PictureLabel& label, double mm_per_pixel);

}  // namespace loomlight
