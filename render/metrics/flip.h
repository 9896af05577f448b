#pragma once

#include <vector>

#include "render/metrics/linear_picture.h"

namespace loomlight {

/// How pictures are looked at.
struct Viewing {
  /// Light is multiplied by 2^exposure_stops and cut to [0, 1], which is what the display can show.
  double exposure_stops = 0;
  /// Pixels per degree of visual angle; 67 is that of the paper: a display of 0.7 m and 3840 pixels, seen from 0.7 m.
  double pixelsPerDegree = 67;
  static constexpr double kMinPixelsPerDegree = 1, kMaxPixelsPerDegree = 300;
};

/// FLIP (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020): how much an eye sees change when two
/// pictures alternate in one place, for every pixel, from 0 to 1. Both pictures are blurred as an eye's contrast
/// sensitivity blurs them, compared by colour, and differences of edges and points raise what differs:
///
///   colour c = redistributed(HyAB(Hunt(Lab(blurred A)), Hunt(Lab(blurred B)))^0.7), feature f, FLIP = c^(1 - f)
///
/// Symmetric. The mean over the pixels is the number to quote. Pictures of the same size, all pixels finite. The paper
/// starts from 8-bit sRGB; we from light, so nothing is lost to quantisation. `threads`: 0 for all.
std::vector<float> flip(const LinearPicture& one, const LinearPicture& other, const Viewing& viewing, int threads = 0);

}  // namespace loomlight
