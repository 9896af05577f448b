#include "render/scene/yarn_curves.h"

#include <algorithm>

#include "render/scene/place_in_cloth.h"

namespace loomlight {

bool YarnCurves::lay(const ClothGeometry& geometry, int cells, const ClothToWorld& toWorld, const Task& task) {
  for (int cell = 0; cell < cells; ++cell) {
    if (task.stopped()) return false;
    firstOfCell_.push_back(static_cast<uint32_t>(curves_.segments().size()));
    const int end = system_ == System::warp ? index_ : cell, pick = system_ == System::warp ? cell : index_;
    const glm::vec2 centre((end + 0.5) * geometry.warpPitch_mm(), (pick + 0.5) * geometry.weftPitch_mm());
    curves_.add(geometry.strands(geometry.key(system_, pick, end)), [&](glm::vec3 usz) -> std::optional<glm::vec3> {
      const auto point = toWorld(inCloth(usz, system_, centre));
      return point ? std::optional(point->world) : std::nullopt;
    });
  }
  return true;
}

int YarnCurves::cellOf(uint32_t segment) const {
  return static_cast<int>(std::upper_bound(firstOfCell_.begin(), firstOfCell_.end(), segment) - firstOfCell_.begin()) -
         1;
}

uint32_t YarnCurves::segmentsBefore(int cells) const {
  return cells < static_cast<int>(firstOfCell_.size()) ? firstOfCell_[static_cast<size_t>(cells)]
                                                       : static_cast<uint32_t>(curves_.segments().size());
}

}  // namespace loomlight
