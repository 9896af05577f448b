#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/geometry/cloth/cell_codes.h"
#include "core/geometry/cloth/yarn_cell_key.h"
#include "core/geometry/cloth/yarn_table.h"
#include "core/geometry/yarn/cell_strands.h"

namespace loomlight {

/// Numbers a designer wants to see, from the geometry itself.
struct ClothMeasures {
  double thickness_mm = 0;  ///< over the yarns' bodies, hairs excluded
  double crimpWarp = 0;     ///< (length of yarn - length of cloth) / length of cloth
  double crimpWeft = 0;
  double arealMass_g_m2 = 0;  ///< of the yarns' counts, setts and crimps
  /// Share of the plane, 0..1, that lies under yarns, as wide as they are pressed, evenly apart, hairs excluded: the
  /// ends' and the picks' together, less what lies under both. Gaps between the fibres of a yarn count as covered.
  double cover = 0;
  double segmentsPerRepeat = 0;  ///< of fibres, averaged over the phases
};

/// A flat piece of cloth of `ends` x `picks` crossings, as geometry: which key every cell of it has, and the fibres of
/// any key. Immutable, and small: no fibre is stored. Cell (pick, end) spans x in [end, end + 1) * warpPitch and y in
/// [pick, pick + 1) * weftPitch; the cloth's corner is the origin, z = 0 its mid-plane, +z its face.
class ClothGeometry {
 public:
  /// Throws nothing for a valid fabric (core/fabric/model/validate.h). `ends`, `picks`: size of the piece, >= 1. Shares
  /// the models of the yarns that `previous` (may be null) has too. Sketched: the yarns that take long to make are
  /// there for a first look, their fibres where they are but for overlaps; those that `previous` has are as they should
  /// be. Once `task` is stopped the rest is made in no time, to be thrown away.
  ClothGeometry(const Fabric& fabric, int ends, int picks, const ClothGeometry* previous = nullptr,
                bool sketched = false, const Task& task = oneThread(), const Tiling& tiling = {});

  /// The yarns, whatever the weave; and what they do in each cell, whatever their shape.
  const YarnTable& yarns() const { return yarns_; }
  const CellCodes& codes() const { return codes_; }
  int ends() const { return ends_; }
  int picks() const { return picks_; }

  /// The yarn of `system` in cell (pick, end); any integers: the cloth goes on beyond its edges as its repeat does.
  /// Costs about a dozen look-ups.
  YarnCellKey key(System system, int pick, int end) const;
  /// The key up to the phase and the stretch: that of all cells of a code, with both 0.
  YarnCellKey shapeKey(System system, ShapeCode code) const { return yarns_.shapeKey(system, shapeOf(code)); }
  /// Where on its yarn the cell lies.
  YarnTable::Place place(System system, int pick, int end) const;
  /// Whether this is the same piece but for its weave: a cell whose code is the same has the same fibres.
  bool differsInWeaveOnly(const ClothGeometry& other) const;

  // What is asked most, of the parts:
  double warpPitch_mm() const { return yarns_.warpPitch_mm(); }
  double weftPitch_mm() const { return yarns_.weftPitch_mm(); }
  bool isSketched() const { return yarns_.isSketched(); }
  double minYarnDiameter_mm() const { return yarns_.minYarnDiameter_mm(); }
  double halfThickness_mm() const { return yarns_.halfThickness_mm(); }
  const YarnGeometry& yarn(System system, int geometryClass) const {
    return yarns_.model(system, geometryClass).geometry;
  }
  /// YarnModel::separation.
  double separation(System system, int geometryClass) const { return yarns_.model(system, geometryClass).separation; }
  int yarnIndex(System system, int index) const { return yarns_.yarnIndex(system, index); }
  int geometryClass(System system, int index) const { return yarns_.geometryClass(system, codes_.kind(system, index)); }
  int repeatEnds() const { return codes_.repeatEnds(); }
  int repeatPicks() const { return codes_.repeatPicks(); }
  const Weave& weave() const { return codes_.weave(); }
  CellStrands strands(const YarnCellKey& key) const { return yarns_.strands(key); }

  /// What a designer should know where threads cannot lie as unevenly as is asked.
  std::vector<std::string> spacingRemarks() const;

  /// Over one repeat, or the piece where that is smaller.
  ClothMeasures measure() const;
  /// Cells of one shape: a key with phase and stretch 0, and how many there are.
  struct CellCount {
    YarnCellKey shape;
    double cells = 0;
  };
  /// Measures from the counts of the cells of warp and of weft, where these are known: it takes time for each shape
  /// instead of each cell.
  ClothMeasures measure(const std::array<std::vector<CellCount>, 2>& counts) const;

  /// A piece of one crossing, sketched: pitches, repeats and twist are those of the cloth, its thickness nearly, and no
  /// yarn takes long to make.
  static ClothGeometry outline(const Fabric& fabric) { return ClothGeometry(fabric, 1, 1, nullptr, true); }

 private:
  YarnTable yarns_;
  CellCodes codes_;
  int ends_ = 0, picks_ = 0;
};

}  // namespace loomlight
