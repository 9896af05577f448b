#pragma once

#include <optional>

#include "render/media/shell_walk.h"
#include "tests/support/voxel_extinction.h"
#include "tests/support/voxel_march.h"

namespace loomlight::test {

// One ray through the voxels of draped cloth, without lanes: what tests hold the lanes against.

/// The sum over a voxel's components, of which each counts with its share; 1/mm.
template <class Share = WholeExtinction>
float sumExtinction(const YarnTables& yarns, const VoxelContent& content, const LocalDrape& drape, glm::vec3 direction,
                    const Share& share = {}) {
  float sum = 0;
  forEachComponent(yarns, content, drape, [&](const VoxelFibres& component) {
    sum += extinction(component.fibres, *component.optics, direction) * share(component);
  });
  return sum;
}

/// A ray on its way through the voxels with content of draped cloth, in order. Parameters are world distances from
/// where it began.
class VoxelWalk {
 public:
  /// As ShellWalk.
  VoxelWalk(const TraceData& cloth, const ScenePoint& from, glm::vec3 direction, float tMax)
      : volume_(*cloth.volume), shell_(cloth, from, direction, tMax) {}

  /// False where nothing is left.
  bool next() {
    while (!march_ || !march_->next()) {
      if (!shell_.next()) return false;
      const ShellSegment& s = shell_.segment();
      march_.emplace(volume_, s.clothOrigin, s.clothDirection, s.tEnter, s.tLeave);
    }
    return true;
  }

  // Where it stands, until it goes on:
  const VoxelContent& content() const { return march_->content(); }
  float enter() const { return shell_.segment().passed + march_->enter(); }
  float leave() const { return shell_.segment().passed + march_->leave(); }
  const LocalDrape& drape() const { return shell_.segment().drape; }

 private:
  const ClothVolume& volume_;
  ShellWalk shell_;
  std::optional<ClothVolume::March> march_;
};

}  // namespace loomlight::test
