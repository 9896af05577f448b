#pragma once

#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// Which stages an edit leaves out of date; everything else may be kept. A stage that is named may still find parts to
/// reuse: bricks are shared by key, and only keys know which of them a changed crossing touches.
struct Impact {
  bool allBricks = false;          ///< sett or resolution: every voxel
  std::vector<int> reshapedYarns;  ///< the yarns in use, by new index, whose fibres lie differently: their bricks
  bool crossings = false;          ///< which side yarns cross on, or yarns of which shape: bricks whose key changes
  bool threads = false;            ///< which yarn a thread uses: what colour looks up by thread; no voxel by itself
  bool drape = false;              ///< the surface the cloth lies on
  bool materials = false;          ///< fibre optics: BCSDF tables, absorption
  bool lighting = false;
  bool film = false;  ///< the samples taken so far are of another picture

  /// Nothing to do: the names, the notes or the number of samples changed, or nothing at all.
  bool nothing() const { return !film; }
  /// Voxels are out of date. The cloth's thickness may change with them, and a Shell hangs on that.
  bool volume() const { return allBricks || crossings || !reshapedYarns.empty(); }
  /// Volume or shell are out of date.
  bool cloth() const { return volume() || threads || drape; }
};

/// What the step from one fabric to another puts out of date. Pure, and the one place that decides it. Both valid.
Impact impact(const Fabric& before, const Fabric& after);

/// Whether volume and shell of the one serve the other: not impact(before, after).cloth(), and mostly for less.
bool sameCloth(const Fabric& before, const Fabric& after);

}  // namespace loomlight
