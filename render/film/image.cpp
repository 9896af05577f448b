#include "render/film/image.h"

#include <algorithm>

#include "render/film/pixel_rect.h"

namespace loomlight {

const Image::Channel* Image::find(const std::string& name) const {
  const auto found = std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == name; });
  return found == channels.end() ? nullptr : &*found;
}

std::vector<float>& Image::add(std::string name) {
  channels.push_back({std::move(name), std::vector<float>(pixelCount(width, height))});
  return channels.back().values;
}

}  // namespace loomlight
