#pragma once

#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/fabric/model/stages.h"

namespace loomlight {

/// What the step from one fabric to another leaves out of date; everything else may be kept. A stage that is named may
/// still find parts to reuse: bricks are shared by key, and only keys know which of them a changed crossing touches.
struct Changes {
  Stages stages;
  std::vector<int> yarns;   ///< in use, whose fibres lie differently: new indices, ascending
  std::vector<int> fibres;  ///< whose optics differ: new indices, ascending
  bool crossings = false;   ///< which side yarns cross on, or yarns of which shape

  /// The samples taken so far are of another picture.
  bool picture() const { return !stages.within(Stage::label); }
  /// Voxels are out of date. The cloth's thickness may change with them, and a Shell hangs on that.
  bool voxels() const { return stages.any(Stage::shape | Stage::grid); }
  /// Volume or shell are out of date.
  bool cloth() const { return voxels() || stages.any(Stage::thread | Stage::drape); }
  /// The medium that light is traced through is out of date. It takes seconds to make fibres, so a change of the camera
  /// must not name it.
  bool medium() const { return cloth() || stages.any(Stage::optics); }
  /// Nothing but which crossings are warp over may have changed.
  bool crossingsAlone() const { return stages.within(Stage::shape | Stage::label) && yarns.empty(); }
};

/// Pure, and the one place that decides what an edit puts out of date: from the stages that the fields in which the
/// fabrics differ name in field_tables.h. Values that are not in use, such as the twist of plies in a yarn of one ply,
/// change nothing. Both valid.
Changes changes(const Fabric& before, const Fabric& after);

/// Whether the fibres of yarn `a` of one fabric lie as those of yarn `b` of another, or of the same, whatever they are
/// called and numbered. It is the fields of Stage::shape that are compared.
bool sameShape(const Fabric& before, int a, const Fabric& after, int b);

}  // namespace loomlight
