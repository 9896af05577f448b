#include "render/display/resample.h"

#include <algorithm>
#include <cmath>

#include "render/film/pixel_rect.h"

namespace loomlight {

Between::Between(int pixel, float ratio, float offset, int count) {
  const float place = (static_cast<float>(pixel) + 0.5f) * ratio - 0.5f + offset, whole = std::floor(place);
  first = std::clamp(static_cast<int>(whole), 0, count - 1);
  second = std::clamp(static_cast<int>(whole) + 1, 0, count - 1);
  share = place - whole;
}

glm::vec4 resampled(std::span<const glm::vec4> picture, int width, const Between& x, const Between& y) {
  const auto at = [&](int u, int v) { return picture[pixelIndex(u, v, width)]; };
  return glm::mix(glm::mix(at(x.first, y.first), at(x.second, y.first), x.share),
                  glm::mix(at(x.first, y.second), at(x.second, y.second), x.share), y.share);
}

}  // namespace loomlight
