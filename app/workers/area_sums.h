#pragma once

#include <cstddef>
#include <vector>

namespace loomlight {

/// Sums over any rectangle of a window, from running sums over all that begin in its corner.
class AreaSums {
 public:
  template <class Value>
  AreaSums(int width, int height, Value&& value)
      : stride_(width + 1), sums_(static_cast<size_t>(stride_) * (height + 1)) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) at(x + 1, y + 1) = value(x, y) + at(x, y + 1) + at(x + 1, y) - at(x, y);
  }
  double sum(int left, int top, int right, int bottom) const {
    return at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
  }

 private:
  double& at(int x, int y) { return sums_[static_cast<size_t>(y) * stride_ + x]; }
  double at(int x, int y) const { return sums_[static_cast<size_t>(y) * stride_ + x]; }

  int stride_;
  std::vector<double> sums_;
};

}  // namespace loomlight
