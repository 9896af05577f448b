#pragma once

#include <memory>

#include "render/display/frame.h"

namespace loomlight {

/// An earlier picture of what a new one shows: seen where that has no samples yet. A coarse one is gone from a pixel
/// with its first sample. Of a fine one, each new sample takes the place of one of its own, so that the new picture
/// comes as fast as it gets good: with x of n samples replaced, the variance is (1 - x)^2 / n + x / n, never more than
/// the old picture's, and after n samples nothing of that is left. One of more than kMostSamples counts as so many and
/// is gone sooner, with a little more noise after it than before.
///
/// A moved picture shows another view from where this one is: where it keeps a pixel that one counts as some samples,
/// and the rest is coarse.
class StandIn {
 public:
  explicit StandIn(std::shared_ptr<const Frame> earlier);
  /// A moved picture. `kept` has a value for each of its pixels, 0 where it is coarse; the others count as so many
  /// samples.
  StandIn(std::shared_ptr<const Frame> moved, uint32_t samples, std::vector<uint8_t> kept);

  /// Its share of a pixel that has so many samples of its own: falls from 1 to exactly 0 at samples().
  float share(uint32_t samples) const;
  /// The same for this pixel of the viewport, which may be a coarse one.
  float shareAt(int x, int y, uint32_t samples) const;
  bool isFineAt(int x, int y) const;
  bool isMoved() const { return !kept_.empty(); }
  /// Whether it says more than coarse passes do: it has its detail from another view, or from light that is known.
  bool outlastsCoarse() const { return isMoved() || earlier_->shared; }
  bool isYoungView() const { return isMoved() && samples_ < kClearSamples; }  ///< a moved picture that was not clear
  /// More would let it linger where the new picture differs from it.
  static constexpr int kMostSamples = 4 * kClearSamples;
  /// Of every pixel, after which nothing of it is left; kMostSamples at most.
  uint32_t samples() const { return samples_; }
  const Frame& frame() const { return *earlier_; }
  bool knowsVariance() const { return !earlier_->variances.empty(); }

  // At a pixel of the viewport, whose resolution is divided by `divider`.
  glm::vec4 light(int x, int y, int divider) const;   ///< as traced
  glm::vec4 helped(int x, int y, int divider) const;  ///< as displayed; see Frame
  Film::Hit hit(int x, int y, int divider) const;
  /// Of the luminance at full resolution, mixed with a mean of so many samples; `own`: its variance, where it has two.
  float variance(int x, int y, uint32_t samples, float own) const;

 private:
  glm::vec4 between(std::span<const glm::vec4> pixels, int x, int y, int divider) const;
  size_t nearest(int x, int y, int divider) const;

  std::shared_ptr<const Frame> earlier_;
  uint32_t samples_;
  std::vector<uint8_t> kept_;  ///< empty unless it is a moved picture
};

}  // namespace loomlight
