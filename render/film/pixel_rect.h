#pragma once

namespace loomlight {

/// Pixels of a picture; x to the right, y downwards, from its top left.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelRect&) const = default;
};

}  // namespace loomlight
