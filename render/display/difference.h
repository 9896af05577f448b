#pragma once

#include <optional>
#include <vector>

#include "render/display/frame.h"

namespace loomlight {

/// How a picture differs from the truth within a window.
struct Difference {
  static constexpr float kGain = 4;  ///< of the map: white is a difference of 1 / kGain of the truth's mean luminance
  int width = 0, height = 0;
  /// Linear heat colours, opaque: what differs in luminance, averaged over 5 x 5 pixels, beyond twice the standard
  /// error that noise leaves. So black means that nothing is known to differ, and the map appears as samples come.
  std::vector<glm::vec4> map;
  double mean_percent = 0;   ///< (picture - truth) / truth, of the mean luminance
  double error_percent = 0;  ///< standard error of that, by the noise of both
};

/// Null before both have two samples in each pixel of the window, and where the truth is black.
std::optional<Difference> differenceOf(const Film& picture, const Film& truth, const PixelRect& window);

/// The colours of the map from no difference to 1 / kGain, in even steps; linear.
std::vector<Rgb> differenceScale(int steps);

}  // namespace loomlight
