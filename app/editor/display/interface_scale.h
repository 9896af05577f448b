#pragma once

#include <algorithm>
#include <cmath>

namespace loomlight {

/// Pixels per unit of the interface in a window of width x height pixels: as wanted, but never so large that no room is
/// left for the cloth. Room counts in steps, since fonts are made anew with each.
inline float interfaceScale(float wanted, int width, int height) {
  constexpr float kLeastWidth = 900, kLeastHeight = 540, kStep = 0.125f;  // of a desk that can be worked at
  const float room = std::min(static_cast<float>(width) / kLeastWidth, static_cast<float>(height) / kLeastHeight);
  return std::min(wanted, std::max(1.0f, kStep * std::floor(room / kStep)));
}

}  // namespace loomlight
