#pragma once

#include "core/base/random_lanes.h"
#include "core/base/simd.h"

namespace loomlight {

/// Two points of the unit hemisphere about z, each uniform, on opposite sides of it, and one as high as the other is
/// low. T: of one path, or of several side by side.
template <class T>
struct AntitheticPoints {
  Vec3Of<T> first, second;

  explicit AntitheticPoints(RandomLanes<T>& random) {
    T x{}, y{}, square = broadcast<T>(1);
    for (MaskOf<T> pending = random.inUse(); any(pending);) {
      const auto [first, second] = random.uniformPair(pending);
      const T u = 2 * first - 1, v = 2 * second - 1;
      const T inDisc = u * u + v * v;
      x = pending ? u : x;
      y = pending ? v : y;
      square = pending ? inDisc : square;
      pending = pending & ((square > 1) | (square < 1e-12f));
    }
    // Uniform heights are those of Lambert's equal-area map of the disc.
    const T height = square, inverse = 1 / squareRoot(square);
    const T low = squareRoot(1 - height * height) * inverse, high = -squareRoot(height * (2 - height)) * inverse;
    first = {low * x, low * y, height};
    second = {high * x, high * y, 1 - height};
  }
};

}  // namespace loomlight
