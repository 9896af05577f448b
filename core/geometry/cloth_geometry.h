#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/geometry/cell_strands.h"
#include "core/geometry/crossing.h"
#include "core/geometry/yarn_geometry.h"
#include "core/geometry/yarn_path.h"

namespace loomlight {

/// All that the fibres of one yarn in one crossing cell depend on, and nothing more: equal keys have equal fibres,
/// voxel for voxel. Colour and optics are not in it.
struct CellKey {
  System system = System::warp;
  int yarn = 0;   ///< geometry class of the yarn: equal for yarns that differ only in colour
  int phase = 0;  ///< where in the yarn's own period this cell lies, 0 <= phase < YarnGeometry::period
  PathNode previous, here, next;
  bool operator==(const CellKey&) const = default;
};
uint64_t hash(const CellKey& key);

/// Numbers a designer wants to see, from the geometry itself.
struct ClothMeasures {
  double thickness_mm = 0;  ///< over the yarns' bodies, hairs excluded
  double crimpWarp = 0;     ///< (length of yarn - length of cloth) / length of cloth
  double crimpWeft = 0;
  double arealMass_g_m2 = 0;     ///< of the yarns' counts, setts and crimps
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
                bool sketched = false, const Task& task = oneThread());
  bool isSketched() const;  ///< any of the yarns

  int ends() const { return ends_; }
  int picks() const { return picks_; }
  double warpPitch_mm() const { return warpPitch_mm_; }
  double weftPitch_mm() const { return weftPitch_mm_; }
  /// All fibres, hairs too, lie in |z| <= this. Like all of a yarn's shape it does not depend on the weave.
  double halfThickness_mm() const { return halfThickness_mm_; }
  double minYarnDiameter_mm() const;  ///< of the yarns that the cloth uses
  double minFibreRadius_mm() const;   ///< likewise

  /// The yarn of `system` in cell (pick, end); any integers: the cloth goes on beyond its edges as its repeat does.
  /// Costs about a dozen look-ups.
  CellKey key(System system, int pick, int end) const;
  /// A class that occurs in the system's sequence.
  const YarnGeometry& yarn(System system, int geometryClass) const;
  /// Index into Fabric::yarns of an end or a pick: for colour and optics, never for shape.
  int yarnIndex(System system, int index) const;

  /// Smallest periods, in crossings, after which key() repeats up to the phase.
  int repeatEnds() const { return repeatEnds_; }
  int repeatPicks() const { return repeatPicks_; }
  /// The key up to the phase: key(system, pick, end) with phase 0; and the phase alone, which counts on along the yarn
  /// from a start that differs from yarn to yarn, so that neighbours are not in step.
  int phase(System system, int pick, int end) const;

  /// The key up to the phase, as a number: equal codes have equal keys.
  using ShapeCode = uint64_t;
  /// Those of codes.size() cells in a row along a yarn, from cell `along` on; much cheaper than as many keys.
  void shapeCodes(System system, int across, int along, std::span<ShapeCode> codes) const;
  /// The same, cheaper still for many cells of an end, whose crossings lie apart in the weave: `crossings` are those
  /// along the yarn over the weave's repeat, as in Weave::row() and Weave::columns().
  void shapeCodes(System system, int across, int along, std::span<const uint8_t> crossings,
                  std::span<ShapeCode> codes) const;
  CellKey shapeKey(System system, ShapeCode code) const;
  /// A changed crossing changes the codes of cells that are so far away along its two yarns, and no others.
  static constexpr int kCrossingReach = kMaxFloatDistance + 1;

  const Weave& weave() const { return weave_; }
  int geometryClass(System system, int index) const;  ///< of the yarn of an end or a pick; any integer
  /// Whether this is the same piece but for its weave: a cell whose shape code is the same has the same fibres.
  bool differsInWeaveOnly(const ClothGeometry& other) const;
  /// Whose classes are whose: [system][class of `other`] is the class here, -1 of those that the cloth does not use.
  using ClassNames = std::array<std::vector<int>, 2>;
  /// Where threads are of one class here just where they are in `other`, and cells of one shape likewise: whatever the
  /// yarns have become, a map of the other's shapes is one of these. Nothing where they are not.
  std::optional<ClassNames> namesOfClasses(const ClothGeometry& other) const;
  /// What a code of the other is here.
  static ShapeCode renamed(System system, ShapeCode code, const ClassNames& names);

  /// The fibres of a cell. A pure function of the key (and of this geometry's yarns).
  CellStrands strands(const CellKey& key) const;
  /// Length of the yarn's axis in the cell, mm.
  double axisLength_mm(const CellKey& key) const;

  /// Over one repeat, or the piece where that is smaller.
  ClothMeasures measure() const;
  /// Cells of one shape: a key with phase 0, and how many there are.
  struct CellCount {
    CellKey shape;
    double cells = 0;
  };
  /// The same of cells that have been counted already, those of warp and of weft: costs what there are shapes.
  ClothMeasures measure(const std::array<std::vector<CellCount>, 2>& counts) const;

 private:
  struct SystemGeometry {
    std::vector<std::shared_ptr<const YarnModel>> yarns;  ///< per geometry class; null where the system has none
    std::vector<int> sequence;                            ///< Fabric::yarns index per end or pick
    std::vector<int> classes;                             ///< the same as geometry classes, in their shortest repeat
  };
  const SystemGeometry& of(System system) const { return systems_[static_cast<size_t>(system)]; }
  PathNode node(System system, int own, int other, bool over, int floatDistance) const;
  bool sameNodes(const ClothGeometry& other) const;
  std::vector<int> nodeGroups(System system, int own, const std::vector<int>& crossed) const;
  template <class WarpOver>
  void shapeCodesOf(System system, int across, int along, const WarpOver& warpOver, std::span<ShapeCode> codes) const;
  void resolveYarns(const Fabric& fabric, const ClothGeometry* previous, bool sketched, const Task& task);
  void findRepeat();
  void findThickness();

  std::array<SystemGeometry, 2> systems_;
  std::vector<Crossing> crossings_;  ///< warp class * classCount + weft class
  int classCount_ = 0;
  Weave weave_;
  int ends_ = 0, picks_ = 0, repeatEnds_ = 1, repeatPicks_ = 1;
  double warpPitch_mm_ = 0, weftPitch_mm_ = 0, halfThickness_mm_ = 0;
};

}  // namespace loomlight
