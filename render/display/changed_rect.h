#pragma once

#include <algorithm>
#include <span>

#include "render/film/pixel_rect.h"

namespace loomlight {

/// The smallest rectangle that holds all pixels in which two pictures of `width` differ, row by row from the top left:
/// empty where they are the same, the whole where they are of different heights. It costs nearly nothing where all has
/// changed, and where little has it is cheaper to look for that than to hand on the rest. same(Pixel, Pixel).
template <class Pixel, class Same>
PixelRect changedRect(std::span<const Pixel> before, std::span<const Pixel> now, int width, const Same& same) {
  const int height = width > 0 ? static_cast<int>(now.size()) / width : 0;
  if (before.size() != now.size()) return {0, 0, width, height};
  int left = width, right = 0, top = height, bottom = 0;
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<size_t>(y) * static_cast<size_t>(width);
    const auto a = before.subspan(row, static_cast<size_t>(width)), b = now.subspan(row, static_cast<size_t>(width));
    const auto first = static_cast<int>(std::mismatch(a.begin(), a.end(), b.begin(), same).first - a.begin());
    if (first == width) continue;
    const auto last = static_cast<int>(std::mismatch(a.rbegin(), a.rend(), b.rbegin(), same).first - a.rbegin());
    left = std::min(left, first);
    right = std::max(right, width - last);
    top = std::min(top, y);
    bottom = y + 1;
  }
  return top < bottom ? PixelRect{left, top, right - left, bottom - top} : PixelRect{};
}

}  // namespace loomlight
