#include "render/display/display_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "core/base/parallel.h"

namespace loomlight {

Pixels8 displayPicture(const Frame& frame, const Tone& tone) {
  Pixels8 pixels{frame.width, frame.height, 3, {}};
  pixels.bytes.reserve(3 * frame.rgba.size());
  // The background is not exposed, and toDisplay() exposes all.
  const float unexposed = std::exp2(-tone.exposure_stops);
  for (const glm::vec4& pixel : frame.rgba) {
    const Rgb colour = toDisplay(Rgb(pixel) + (1 - pixel.a) * unexposed * tone.background, tone);
    for (int c = 0; c < 3; ++c) pixels.bytes.push_back(byteOf(colour[c]));
  }
  return pixels;
}

Pixels8 differencePicture(const Pixels8& first, const Pixels8& second) {
  assert(first.channels == 3 && second.channels == 3);
  constexpr int kGain = 4, kReach = 1;  // of the mean, pixels to each side
  constexpr uint8_t kMiddleGrey = 118;
  const int width = first.width, height = first.height;
  const double ratio = static_cast<double>(second.height) / height;
  std::vector<int> columns;  // of the second, for each of the first
  for (int x = 0; x < width; ++x)
    columns.push_back(static_cast<int>(std::floor((x + 0.5 - 0.5 * width) * ratio + 0.5 * second.width)));
  const auto known = [&](int column) { return column >= 0 && column < second.width; };
  const auto begin = static_cast<int>(std::find_if(columns.begin(), columns.end(), known) - columns.begin());
  const auto end = static_cast<int>(columns.rend() - std::find_if(columns.rbegin(), columns.rend(), known));
  Pixels8 difference{width, height, 3, std::vector<uint8_t>(first.bytes.size(), kMiddleGrey)};
  const auto pixel = [](const Pixels8& picture, int x, int y) {
    const uint8_t* rgb = picture.bytes.data() + 3 * pixelIndex(x, y, picture.width);
    return glm::ivec3(rgb[0], rgb[1], rgb[2]);
  };
  parallelFor(static_cast<size_t>(height), 0, [&](size_t row) {
    const int y = static_cast<int>(row);
    const int top = std::max(0, y - kReach), bottom = std::min(height, y + kReach + 1);
    std::vector<glm::ivec3> sums(static_cast<size_t>(width));  // of the rows about this one
    for (int v = top; v < bottom; ++v)
      for (int x = begin; x < end; ++x)
        sums[x] += pixel(first, x, v) - pixel(second, columns[x], static_cast<int>((v + 0.5) * ratio));
    for (int x = begin; x < end; ++x) {
      const int left = std::max(begin, x - kReach), right = std::min(end, x + kReach + 1);
      const glm::ivec3 sum = std::accumulate(sums.begin() + left, sums.begin() + right, glm::ivec3(0));
      const int count = (right - left) * (bottom - top);
      uint8_t* rgb = difference.bytes.data() + 3 * pixelIndex(x, y, width);
      for (int c = 0; c < 3; ++c)
        rgb[c] = static_cast<uint8_t>(std::min(255, (kGain * std::abs(sum[c]) + count / 2) / count));
    }
  });
  return difference;
}

}  // namespace loomlight
