#include "render/scene/yarn_curves.h"

#include <algorithm>

#include "render/scene/place_in_cloth.h"

namespace loomlight {

bool YarnCurves::lay(const ClothGeometry& geometry, int cells, const ClothToWorld& toWorld, const Task& task) {
  for (int cell = 0; cell < cells; ++cell) {
    if (task.stopped()) return false;
    firstOfCell_.push_back(static_cast<uint32_t>(segments_.size()));
    const int end = system_ == System::warp ? index_ : cell, pick = system_ == System::warp ? cell : index_;
    const CellStrands strands = geometry.strands(geometry.key(system_, pick, end));
    const glm::vec2 centre((end + 0.5) * geometry.warpPitch_mm(), (pick + 0.5) * geometry.weftPitch_mm());
    for (size_t s = 0; s < strands.strands.size(); ++s) {
      const CellStrands::Strand& strand = strands.strands[s];
      bool joined = false;
      for (uint32_t i = strand.first; i < strand.first + strand.count; ++i) {
        const auto point = toWorld(inCloth(strands.points[i], system_, centre));
        if (point) {
          if (joined) {
            segments_.push_back(static_cast<uint32_t>(vertices_.size() - 1));
            strandOfSegment_.push_back(static_cast<uint32_t>(s));
          }
          vertices_.emplace_back(point->world, strands.fibreRadius_mm);
        }
        joined = point.has_value();
      }
    }
  }
  return true;
}

glm::vec3 YarnCurves::tangent(uint32_t segment) const {
  const uint32_t first = segments_[segment];
  return glm::normalize(glm::vec3(vertices_[first + 1]) - glm::vec3(vertices_[first]));
}

int YarnCurves::cellOf(uint32_t segment) const {
  return static_cast<int>(std::upper_bound(firstOfCell_.begin(), firstOfCell_.end(), segment) - firstOfCell_.begin()) -
         1;
}

uint32_t YarnCurves::segmentsBefore(int cells) const {
  return cells < static_cast<int>(firstOfCell_.size()) ? firstOfCell_[static_cast<size_t>(cells)]
                                                       : static_cast<uint32_t>(segments_.size());
}

size_t YarnCurves::bytes() const {
  return vertices_.size() * sizeof(glm::vec4) +
         (segments_.size() + strandOfSegment_.size() + firstOfCell_.size()) * sizeof(uint32_t);
}

}  // namespace loomlight
