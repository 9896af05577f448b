#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/yarn/cell_strands.h"
#include "render/scene/embree.h"

namespace loomlight {

/// Strands as Embree traces them: round linear curves, of two points each.
class RoundCurves {
 public:
  /// Adds the strands of a cell. positionOf(point of CellStrands): where that lies, or nullopt where a strand ends.
  template <class PositionOf>
  void add(const CellStrands& cell, const PositionOf& positionOf);

  const std::vector<glm::vec4>& vertices() const { return vertices_; }  ///< position, radius; mm
  const std::vector<uint32_t>& segments() const { return segments_; }   ///< first vertex of each
  glm::vec3 tangent(uint32_t segment) const {                           ///< unit
    const uint32_t first = segments_[segment];
    return glm::normalize(glm::vec3(vertices_[first + 1]) - glm::vec3(vertices_[first]));
  }
  float radius_mm(uint32_t segment) const { return vertices_[segments_[segment]].w; }
  uint32_t strandOf(uint32_t segment) const { return strandOfSegment_[segment]; }  ///< number in its cell
  size_t bytes() const {
    return vertices_.size() * sizeof(glm::vec4) + (segments_.size() + strandOfSegment_.size()) * sizeof(uint32_t);
  }

  /// A geometry that reads these very curves, which must stay as they are; `filter` hears of every hit. The caller
  /// releases it.
  RTCGeometry geometry(RTCDevice device, RTCFilterFunctionN filter, void* user) const;

  /// Of a filter's hit: whether the ray comes to the surface from inside of the fibre.
  static bool isFromInside(const RTCFilterFunctionNArguments& hit);

 private:
  std::vector<glm::vec4> vertices_;
  std::vector<uint32_t> segments_, strandOfSegment_;
};

template <class PositionOf>
void RoundCurves::add(const CellStrands& cell, const PositionOf& positionOf) {
  for (size_t s = 0; s < cell.strands.size(); ++s) {
    const CellStrands::Strand& strand = cell.strands[s];
    bool joined = false;
    for (uint32_t i = strand.first; i < strand.first + strand.count; ++i) {
      const std::optional<glm::vec3> point = positionOf(cell.points[i]);
      if (point) {
        if (joined) {
          segments_.push_back(static_cast<uint32_t>(vertices_.size() - 1));
          strandOfSegment_.push_back(static_cast<uint32_t>(s));
        }
        vertices_.emplace_back(*point, cell.fibreRadius_mm);
      }
      joined = point.has_value();
    }
  }
}

}  // namespace loomlight
