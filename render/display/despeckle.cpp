#include "render/display/despeckle.h"

#include <algorithm>
#include <array>
#include <vector>

#include "render/film/pixel_rect.h"

namespace loomlight {

void despeckle(std::span<glm::vec4> rgba, int width, int height, float limit) {
  const auto brightness = [](const glm::vec4& c) { return std::max({c.r, c.g, c.b}); };
  std::vector<float> before(rgba.size());
  std::transform(rgba.begin(), rgba.end(), before.begin(), brightness);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::array<float, 9> around{};
      int count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
          around[count++] = before[pixelIndex(u, v, width)];
      std::nth_element(around.begin(), around.begin() + count / 2, around.begin() + count);
      const float most = limit * around[count / 2];
      const size_t i = pixelIndex(x, y, width);
      glm::vec4& pixel = rgba[i];
      const float own = before[i];
      if (own > most) pixel = glm::vec4(glm::vec3(pixel) * (most / own), pixel.a);
    }
}

void soften(std::span<glm::vec4> rgba, int width, int height) {
  const auto mix = [](const glm::vec4& before, const glm::vec4& own, const glm::vec4& after) {
    return 0.25f * (before + 2.0f * own + after);
  };
  std::vector<glm::vec4> rows(rgba.size());
  const auto at = [width](int x, int y) { return pixelIndex(x, y, width); };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      rows[at(x, y)] = mix(rgba[at(std::max(0, x - 1), y)], rgba[at(x, y)], rgba[at(std::min(width - 1, x + 1), y)]);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      rgba[at(x, y)] = mix(rows[at(x, std::max(0, y - 1))], rows[at(x, y)], rows[at(x, std::min(height - 1, y + 1))]);
}

}  // namespace loomlight
