#pragma once

#include <span>
#include <vector>

#include "core/base/units.h"

namespace loomlight {

/// Where on one axis of a picture another one looks, whose pixels are `ratio` of its own wide and begin `offset`
/// of its own pixels after it: between the centres of two pixels, bilinear, as the display enlarges pictures.
struct Between {
  int first = 0, second = 0;
  float share = 0;  ///< of the second

  Between(int pixel, float ratio, float offset, int count);
};

/// The picture, row by row, `width` pixels wide, between four of its pixels.
glm::vec4 resampled(std::span<const glm::vec4> picture, int width, const Between& x, const Between& y);

}  // namespace loomlight
