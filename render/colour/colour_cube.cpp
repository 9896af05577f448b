#include "render/colour/colour_cube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace loomlight {

ColourCube::ColourCube(std::vector<glm::vec4> corners) : corners_(std::move(corners)) {
  assert(corners_.size() == size_t{kSide} * kSide * kSide);
}

glm::vec4 ColourCube::at(const Rgb& encoded) const {
  int low[3];
  float share[3];
  for (int c = 0; c < 3; ++c) {
    const float place = std::sqrt(std::clamp(encoded[c], 0.0f, 1.0f)) * (kSide - 1);
    low[c] = std::min(static_cast<int>(place), kSide - 2);
    share[c] = place - static_cast<float>(low[c]);
  }
  glm::vec4 sum(0.0f);
  for (int corner = 0; corner < 8; ++corner) {
    size_t index = 0;
    float weight = 1;
    for (int c = 2; c >= 0; --c) {
      const int up = corner >> c & 1;
      index = index * kSide + static_cast<size_t>(low[c] + up);
      weight *= up ? share[c] : 1 - share[c];
    }
    sum += weight * corners_[index];
  }
  return sum;
}

}  // namespace loomlight
