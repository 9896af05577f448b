#pragma once

#include <string>
#include <vector>

#include "app/bench/live_clock.h"
#include "core/base/task.h"
#include "render/metrics/linear_picture.h"

namespace loomlight {

/// How far what is shown is from the picture that it converges to, while time passes.
struct ClearCourse {
  struct Point {
    double since_s = 0;  ///< the edit
    double flip = 0;     ///< mean over what is measured of the picture
    int samples = 0;     ///< of every pixel, at least
  };
  std::vector<Point> points;  ///< one for each picture that was shown

  double at(double since_s) const;   ///< FLIP of what is shown then; 1 before the first
  double timeTo(double flip) const;  ///< the first time at which it is no more than that; infinite if never
  double first() const { return points.empty() ? 1.0 : points.front().flip; }
  /// The most by which a picture was worse than the best before it, as a ratio; 1 where none was.
  double worstStepBack() const;
};

/// A picture's least side: three windows find room in it, each as large as an eye blurs.
constexpr int kLeastClearSide_px = 48;

/// How a picture is traced that others are compared with.
struct ClearReferenceTask {
  int width = 0, height = 0;
  uint32_t samples = 0;
  std::string folder;  ///< where it is kept for the next time
};

/// What is measured of a picture: windows spread evenly over it, in display light, so that the picture that it
/// converges to may be traced without tracing all of it.
class ClearReference {
 public:
  /// Traces the windows of the fabric's picture with samples of another seed, or reads them where they are kept.
  /// Nothing to compare with when stopped.
  ClearReference(const Fabric& fabric, const ClearReferenceTask& of, const Task& task);

  /// What the display shows of a frame, in these windows.
  std::vector<LinearPicture> windowsOf(const Frame& frame) const;
  /// Mean FLIP.
  double distance(const std::vector<LinearPicture>& shown, int threads) const;
  /// How far the windows are from what they converge to, as far as chance is the cause, as mean FLIP: they are compared
  /// with themselves at half of their samples, from which they differ as much, in variance, as from that.
  double noise(int threads) const;

 private:
  int width_, height_;
  std::vector<LinearPicture> windows_, halfway_;
};

/// Shows a fabric for so many seconds and measures every picture afterwards, so as not to take time from the tracer.
/// `pictures` (may be null) receives the frames that are shown at these times. Empty when stopped.
ClearCourse watchClear(LiveClock& clock, const Fabric& fabric, const ClearReference& reference, double seconds,
                       const std::vector<double>& times_s, std::vector<std::shared_ptr<const Frame>>* pictures,
                       const Task& task);

}  // namespace loomlight
