#pragma once

#include <algorithm>
#include <cstddef>

namespace loomlight {

/// Pixels of a picture; x to the right, y downwards, from its top left.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelRect&) const = default;
};

/// What of it lies in a picture of this size.
inline PixelRect within(const PixelRect& rect, int width, int height) {
  const int left = std::clamp(rect.x, 0, width), top = std::clamp(rect.y, 0, height);
  return {left, top, std::clamp(rect.x + rect.width, left, width) - left,
          std::clamp(rect.y + rect.height, top, height) - top};
}

// Pictures are kept row by row from the top left.

/// How many pixels a picture of this size has.
inline size_t pixelCount(int width, int height) {
  return static_cast<size_t>(width) * static_cast<size_t>(height);
}
/// The number of a pixel in a picture of this width.
inline size_t pixelIndex(int x, int y, int width) {
  return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
}

// Of a coarse picture each pixel stands for divider x divider of a fine one, from its top left on.

/// How many coarse pixels cover so many fine ones.
inline int coarser(int pixels, int divider) {
  return (pixels + divider - 1) / divider;
}
/// The coarse pixels that cover fine ones.
inline PixelRect coarser(const PixelRect& fine, int divider) {
  const int left = fine.x / divider, top = fine.y / divider;
  return {left, top, coarser(fine.x + fine.width, divider) - left, coarser(fine.y + fine.height, divider) - top};
}
/// The fine pixels that coarse ones stand for.
inline PixelRect finer(const PixelRect& coarse, int divider) {
  return {coarse.x * divider, coarse.y * divider, coarse.width * divider, coarse.height * divider};
}

}  // namespace loomlight
