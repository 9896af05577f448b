#pragma once

#include <span>
#include <vector>

#include "app/bench/clear_course.h"

namespace loomlight {

/// A picture that was shown in a drag.
struct DragPicture {
  size_t step = 0;     ///< that it is of
  double since_s = 0;  ///< the beginning of the drag
  std::vector<LinearPicture> windows;
};

/// Sends the fabrics at this interval. Nothing when stopped.
std::vector<DragPicture> watchDrag(LiveClock& clock, std::span<const Fabric> steps, double interval_s,
                                   const ClearReference& reference, const std::stop_token& stop);

/// How good they are, each beside the view that it is of.
struct DragCourse {
  size_t pictures = 0;
  double interval_s = 0;  ///< between two of them, mean
  double flip = 0;        ///< mean over them
  double worstFlip = 0;   ///< of one of them
};
/// Nothing when stopped.
DragCourse courseOf(std::span<const DragPicture> pictures, std::span<const Fabric> steps,
                    const ClearReferenceTask& references, const Task& task);

}  // namespace loomlight
