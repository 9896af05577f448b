#pragma once

#include <vector>

namespace loomlight {

/// Weights at -radius .. radius.
using Kernel = std::vector<float>;
inline int radiusOf(const Kernel& kernel) {
  return static_cast<int>(kernel.size()) / 2;
}

/// The filters of FLIP for one viewing distance, each as products of kernels along x and along y.
struct FlipKernels {
  explicit FlipKernels(double pixelsPerDegree);

  // Contrast sensitivity; each is a Gaussian along both axes, that of blue-yellow a sum of two.
  Kernel achromatic, redGreen;
  struct Term {
    float weight = 0;
    Kernel kernel;
  };
  Term blueYellow[2];

  // Features: derivative of a Gaussian along one axis, the Gaussian along the other.
  Kernel edge, point, smooth;

  int radius = 0;  ///< the largest
};

}  // namespace loomlight
