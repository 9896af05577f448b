#include "render/metrics/linear_picture.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "render/film/pixel_rect.h"

namespace loomlight {

LinearPicture linearPicture(const Image& image, const std::string& file) {
  LinearPicture picture{image.width, image.height, {}};
  picture.pixels.resize(pixelCount(image.width, image.height));
  const char* const names[] = {"R", "G", "B"};
  for (int i = 0; i < 3; ++i) {
    const Image::Channel* channel = image.find(names[i]);
    if (!channel) throw InputError(fmt::format("{}: expected the channels R, G and B; {} is missing", file, names[i]));
    for (size_t p = 0; p < picture.pixels.size(); ++p) picture.pixels[p][i] = channel->values[p];
  }
  return picture;
}

LinearPicture readLinearPicture(const std::string& file) {
  return linearPicture(readExr(file), file);
}

}  // namespace loomlight
