#include "render/display/picture_buckets.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <numeric>

// How it works. A picture that takes long is made in square buckets, those nearest to its middle first, where the eye
// is. A finished bucket fades out towards neighbours that are not there yet, over a quarter of its side, so that no
// edge between old and new pixels is seen.
namespace loomlight {

PictureBuckets::PictureBuckets(const PixelRect& window, int side)
    : window_(window),
      width_(side > 0 ? side : window.width),
      height_(side > 0 ? side : window.height),
      columns_(coarser(window.width, width_)),
      rows_(coarser(window.height, height_)),
      order_(pixelCount(columns_, rows_)),
      isDone_(order_.size(), false) {
  std::iota(order_.begin(), order_.end(), size_t{0});
  const auto fromMiddle = [this](size_t index) {  // squared, in half pixels
    const PixelRect p = bucket(index);
    const int64_t x = 2 * (p.x - window_.x) + p.width - window_.width;
    const int64_t y = 2 * (p.y - window_.y) + p.height - window_.height;
    return x * x + y * y;
  };
  std::stable_sort(order_.begin(), order_.end(), [&](size_t a, size_t b) { return fromMiddle(a) < fromMiddle(b); });
}

PixelRect PictureBuckets::bucket(size_t index) const {
  const int x = static_cast<int>(index) % columns_ * width_, y = static_cast<int>(index) / columns_ * height_;
  return {window_.x + x, window_.y + y, std::min(width_, window_.width - x), std::min(height_, window_.height - y)};
}

float PictureBuckets::shown(int x, int y) const {
  const int column = (x - window_.x) / width_, row = (y - window_.y) / height_;
  const auto done = [&](int c, int r) {
    const bool outside = c < 0 || r < 0 || c >= columns_ || r >= rows_;
    return outside || isDone_[pixelIndex(c, r, columns_)];
  };
  if (!done(column, row)) return 0;
  const float soft = 0.25f * static_cast<float>(std::min(width_, height_));
  const float left = static_cast<float>(x - window_.x - column * width_) + 0.5f;
  const float top = static_cast<float>(y - window_.y - row * height_) + 0.5f;
  const float right = static_cast<float>(width_) - left, bottom = static_cast<float>(height_) - top;
  float shown = 1;
  for (int v = -1; v <= 1; ++v)
    for (int u = -1; u <= 1; ++u) {
      if (done(column + u, row + v)) continue;
      const float across = u < 0 ? left : u > 0 ? right : 0.0f, down = v < 0 ? top : v > 0 ? bottom : 0.0f;
      shown = std::min(shown, glm::length(glm::vec2(across, down)) / soft);
    }
  return glm::smoothstep(0.0f, 1.0f, shown);
}

}  // namespace loomlight
