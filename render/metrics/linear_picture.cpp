#include "render/metrics/linear_picture.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/rgb.h"
#include "core/base/text.h"
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

LinearPicture linearPicture(const Pixels8& pixels) {
  LinearPicture picture{pixels.width, pixels.height, {}};
  picture.pixels.reserve(pixelCount(pixels.width, pixels.height));
  const auto channels = static_cast<size_t>(pixels.channels);
  for (size_t i = 0; i < pixels.bytes.size(); i += channels) {
    const auto channel = [&](size_t c) { return static_cast<float>(pixels.bytes[i + c]) / 255; };
    const float alpha = channels == 4 ? channel(3) : 1;
    picture.pixels.push_back(alpha * linearFromSrgb({channel(0), channel(1), channel(2)}));
  }
  return picture;
}

LinearPicture readLinearPicture(const std::string& file) {
  return lowerExtension(file) == ".png" ? linearPicture(readPng(file)) : linearPicture(readExr(file), file);
}

}  // namespace loomlight
