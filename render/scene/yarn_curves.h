#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/task.h"
#include "core/geometry/cloth/cloth_geometry.h"
#include "core/shell/cloth_to_world.h"
#include "render/scene/round_curves.h"

namespace loomlight {

/// The fibres of one end or pick as polylines in the world: as the strands of its cells, one cell after the other.
class YarnCurves {
 public:
  YarnCurves(System system, int index) : system_(system), index_(index) {}

  /// Lays the first `cells` cells; strands end where the drape has no cloth. Once only. False when stopped.
  bool lay(const ClothGeometry& geometry, int cells, const ClothToWorld& toWorld, const Task& task);

  System system() const { return system_; }
  int index() const { return index_; }
  const RoundCurves& curves() const { return curves_; }  ///< strands have the same number in every cell of the yarn
  int cellOf(uint32_t segment) const;
  /// Of the first `cells` cells; of all where there are not as many.
  uint32_t segmentsBefore(int cells) const;
  size_t bytes() const { return curves_.bytes() + firstOfCell_.size() * sizeof(uint32_t); }

 private:
  System system_;
  int index_;
  RoundCurves curves_;
  std::vector<uint32_t> firstOfCell_;  ///< into segments
};

}  // namespace loomlight
