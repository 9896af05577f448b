#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/task.h"
#include "core/geometry/cloth_geometry.h"
#include "core/shell/cloth_to_world.h"

namespace loomlight {

/// The fibres of one end or pick as polylines in the world: as the strands of its cells, one cell after the other.
class YarnCurves {
 public:
  YarnCurves(System system, int index) : system_(system), index_(index) {}

  /// Lays the first `cells` cells; strands end where the drape has no cloth. Once only. False when stopped.
  bool lay(const ClothGeometry& geometry, int cells, const ClothToWorld& toWorld, const Task& task);

  System system() const { return system_; }
  int index() const { return index_; }
  const std::vector<glm::vec4>& vertices() const { return vertices_; }  ///< place, radius; mm
  const std::vector<uint32_t>& segments() const { return segments_; }   ///< first vertex of each
  glm::vec3 tangent(uint32_t segment) const;                            ///< unit
  /// Which strand of its cell: a fibre has the same number in every cell of its yarn.
  uint32_t strandOf(uint32_t segment) const { return strandOfSegment_[segment]; }
  int cellOf(uint32_t segment) const;
  /// Of the first `cells` cells; of all where there are not as many.
  uint32_t segmentsBefore(int cells) const;
  size_t bytes() const;

 private:
  System system_;
  int index_;
  std::vector<glm::vec4> vertices_;
  std::vector<uint32_t> segments_, strandOfSegment_;
  std::vector<uint32_t> firstOfCell_;  ///< into segments
};

}  // namespace loomlight
