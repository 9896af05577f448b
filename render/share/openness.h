#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/film/pixel_rect.h"

namespace loomlight {

/// Of the rays through a pixel: how many came into the cloth, and how many of these met none of its fibres.
struct ClothRays {
  uint32_t in = 0, through = 0;
};

/// How open a cloth is, as it is seen pixel by pixel: the share of the rays into it that go through. Few rays tell
/// little of that, so a pixel is drawn towards what is around it (empirical Bayes), which is estimated over the whole
/// picture: the more alike pixels are beside the noise of so few rays, the more their surroundings count for. In a
/// picture whose openings are wider than its pixels, each stays as it is.
///
/// Rays are taken for independent. Those of one pixel are spread evenly over it, so that they know openings about as
/// wide as the pixel better than they are trusted with. Where each pixel has one ray alone, openings that are
/// no wider than two pixels cannot be told from chance, and are shown as open as they are together.
class Openness {
 public:
  static constexpr int kReach = 3;  ///< pixels to each side: some fifty pixels are of nearly the same openness

  /// `pixels`: row by row from the top left; they must outlive it.
  Openness(std::span<const ClothRays> pixels, int width, int height, int threads);

  /// 0..1; of a pixel beside the cloth, 0.
  float at(int x, int y) const;
  /// How many rays of its own a pixel needs, to count for as much as what is around it.
  float worthOfAround_rays() const { return worth_; }

 private:
  size_t indexOf(int x, int y) const { return pixelIndex(x, y, width_); }
  ClothRays around(int x, int y) const;
  float worthOfAround(int threads) const;
  float worthOfBlocks(int threads) const;

  std::span<const ClothRays> pixels_;
  int width_, height_;
  std::vector<ClothRays> rows_;  ///< sums over kReach pixels to either side
  float worth_ = 0;
};

}  // namespace loomlight
