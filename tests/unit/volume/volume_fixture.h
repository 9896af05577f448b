#pragma once

#include <memory>
#include <set>
#include <utility>

#include "core/base/random.h"
#include "core/volume/traverse/cloth_volume.h"

namespace loomlight::volume_test {

/// A loosely set plain weave of single yarns, no hairs.
inline Fabric plainFabric() {
  Fabric fabric;
  fabric.yarns[0].count_tex = 30;
  fabric.yarns[0].plyTwist_per_m = 600;
  fabric.ends_per_cm = 22;
  fabric.picks_per_cm = 20;
  return fabric;
}

/// A tight twill of a two-ply hairy warp over a flat single weft: its yarns spill over their cells.
inline Fabric hairyTwill() {
  Fabric fabric;
  fabric.weave = Weave({{1, 1, 0, 0}, {0, 1, 1, 0}, {0, 0, 1, 1}, {1, 0, 0, 1}});
  Yarn warp, weft;
  warp.plies = 2;
  warp.count_tex = 40;
  warp.yarnTwist_per_m = 500;
  warp.hairiness_per_mm = 8;
  warp.hairLength_mm = 0.5;
  weft.count_tex = 60;
  weft.flattening = 2;
  fabric.yarns = {warp, weft};
  fabric.weftSequence = {1};
  fabric.ends_per_cm = 26;
  fabric.picks_per_cm = 24;
  return fabric;
}

/// The same of yarns that are unevenly spun, the warp with slubs.
inline Fabric slubbyTwill() {
  Fabric fabric = hairyTwill();
  for (Yarn& yarn : fabric.yarns) yarn.evennessCv_percent = 20;
  fabric.yarns[0].slubs_per_m = 15;
  fabric.yarns[0].slubLength_mm = 8;
  return fabric;
}

/// A jacquard: a repeat of `side` crossings a side, floats scattered at random.
inline Fabric jacquard(int side) {
  Fabric fabric = plainFabric();
  Random random(17);
  std::vector<std::vector<uint8_t>> rows(side, std::vector<uint8_t>(side));
  for (int p = 0; p < side; ++p)
    for (int e = 0; e < side; ++e) {
      const bool figure = (p / 30 + e / 40) % 2 == 0;
      rows[p][e] = (e + 3 * p) % 8 == 0 ? !figure : figure;  // satin of 8, warp- and weft-faced
      if (random.below(50) == 0) rows[p][e] ^= 1;
    }
  fabric.weave = Weave(rows);
  return fabric;
}

inline std::shared_ptr<const ClothGeometry> geometryOf(const Fabric& fabric, int ends, int picks) {
  return std::make_shared<const ClothGeometry>(fabric, ends, picks);
}

inline std::shared_ptr<const ClothVolume> volumeOf(const Fabric& fabric, int ends, int picks, int resolution,
                                                   const ClothVolume* previous = nullptr) {
  return ClothVolume::build(geometryOf(fabric, ends, picks), resolution, Task{}, previous);
}

/// Whether all cells have bricks, of the volume's own grid.
inline bool isWhole(const ClothVolume& volume) {
  for (int pick = 0; pick < volume.geometry().picks(); ++pick)
    for (int end = 0; end < volume.geometry().ends(); ++end)
      for (const System system : {System::warp, System::weft})
        if (const BrickView brick = volume.brick(system, pick, end);
            brick.box.blocks() == 0 || brick.cell != volume.grid().perCell())
          return false;
  return true;
}

/// Whether both have the same bricks, byte for byte, in all cells, and count the same.
inline bool sameVolume(const ClothVolume& a, const ClothVolume& b) {
  if (a.grid() != b.grid()) return false;
  std::set<std::pair<const BrickBlock*, const BrickBlock*>> same;
  for (int pick = 0; pick < a.geometry().picks(); ++pick)
    for (int end = 0; end < a.geometry().ends(); ++end)
      for (const System system : {System::warp, System::weft}) {
        const BrickView left = a.brick(system, pick, end), right = b.brick(system, pick, end);
        if (same.insert({left.blocks, right.blocks}).second && !(left == right)) return false;
      }
  const VolumeCounts left = a.counts(), right = b.counts();
  return left.bricks == right.bricks && left.voxels == right.voxels && left.components == right.components &&
         left.bytes == right.bytes && left.segments == right.segments &&
         left.segmentsRepresented == right.segmentsRepresented;
}

}  // namespace loomlight::volume_test
