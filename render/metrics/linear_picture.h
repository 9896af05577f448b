#pragma once

#include <string>
#include <vector>

#include "core/base/units.h"
#include "render/film/image.h"

namespace loomlight {

/// Linear light, as the renderer leaves it: premultiplied, over black. What pictures are measured in.
struct LinearPicture {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  ///< width * height, row by row from the top left
};

/// The channels R, G and B. Throws InputError, naming `file`, when one is missing.
LinearPicture linearPicture(const Image& image, const std::string& file);
/// The light that a screen gives off for pixels encoded in sRGB.
LinearPicture linearPicture(const Pixels8& pixels);
/// From an .exr of ours or anyone's; or a .png, as a screen shows it. Throws InputError.
LinearPicture readLinearPicture(const std::string& file);

inline bool isFinite(const Rgb& c) {
  return !glm::any(glm::isnan(c)) && !glm::any(glm::isinf(c));
}

}  // namespace loomlight
