#include "app/bench/clear_drag.h"

#include <algorithm>

namespace loomlight {

std::vector<DragPicture> watchDrag(LiveClock& clock, std::span<const Fabric> steps, double interval_s,
                                   const ClearReference& reference, const std::stop_token& stop) {
  std::vector<DragPicture> pictures;
  const auto look = [&](const std::shared_ptr<const Frame>& frame, size_t step, double since_s) {
    pictures.push_back({step, since_s, reference.windowsOf(*frame)});
  };
  return clock.drag(steps, interval_s, look, stop) ? pictures : std::vector<DragPicture>{};
}

DragCourse courseOf(std::span<const DragPicture> pictures, std::span<const Fabric> steps,
                    const ClearReferenceTask& references, const Task& task) {
  DragCourse course;
  course.pictures = pictures.size();
  if (pictures.empty()) return course;
  for (const DragPicture& picture : pictures) {
    const ClearReference reference(steps[picture.step], references, task);
    if (task.stopped()) return {};
    const double flip = reference.distance(picture.windows, task.threads);
    course.flip += flip / static_cast<double>(pictures.size());
    course.worstFlip = std::max(course.worstFlip, flip);
  }
  course.interval_s = pictures.back().since_s / static_cast<double>(pictures.size());
  return course;
}

}  // namespace loomlight
