#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/geometry/cloth/cell_codes.h"
#include "core/geometry/cloth/crossing.h"
#include "core/geometry/cloth/thread_kinds.h"
#include "core/geometry/cloth/yarn_cell_key.h"
#include "core/geometry/yarn/cell_strands.h"
#include "core/geometry/yarn/yarn_geometry.h"
#include "core/geometry/yarn/yarn_model.h"

namespace loomlight {

/// After how many ends and picks a piece repeats thread for thread, so that such pieces join side by side; 0: never. In
/// cloth no thread is like another, for each begins somewhere else along its yarn.
struct Tiling {
  int ends = 0, picks = 0;
  bool operator==(const Tiling&) const = default;
};

/// The yarns of a cloth, and how each bends where it crosses any other: all of its shape that no weave changes.
class YarnTable {
 public:
  /// As ClothGeometry.
  YarnTable(const Fabric& fabric, const YarnTable* previous, bool sketched, const Task& task, const Tiling& tiling);
  bool isSketched() const;  ///< any of the yarns

  const Tiling& tiling() const { return tiling_; }
  double warpPitch_mm() const { return warpPitch_mm_; }
  double weftPitch_mm() const { return weftPitch_mm_; }
  /// All fibres, hairs too, lie in |z| <= this.
  double halfThickness_mm() const { return halfThickness_mm_; }
  double minYarnDiameter_mm() const;  ///< of the yarns that the cloth uses, round, as far as their plies stand out
  double minFibreRadius_mm() const;   ///< of the yarns that the cloth uses

  /// Index into Fabric::yarns of an end or a pick; any integer.
  int yarnIndex(System system, int index) const;
  /// What ends or picks are, and how far from where an even sett would have them.
  const ThreadKinds& threads(System system) const { return of(system).threads; }
  int geometryClass(System system, int kind) const {
    return threads(system).kinds[static_cast<size_t>(kind)].geometryClass;
  }
  /// Of a class that occurs in the system's sequence.
  const YarnModel& model(System system, int geometryClass) const;

  YarnCellKey shapeKey(System system, const CellShape& shape) const;  ///< with phase and stretch 0
  struct Place {
    int phase = 0;         ///< in its period
    uint32_t stretch = 0;  ///< of its spool, < Spool::kStretches; 0 where the yarn is even
  };
  /// Where along itself a yarn is in a cell. It counts on from a start that differs from yarn to yarn, so that
  /// neighbours are not in step.
  Place place(System system, int geometryClass, int across, int along) const;
  /// The spool of a class that occurs in the system's sequence; null where the yarn is even.
  const std::shared_ptr<const Spool>& spool(System system, int geometryClass) const {
    return model(system, geometryClass).spool;
  }

  /// The fibres of a cell. A pure function of the key (and of these yarns).
  CellStrands strands(const YarnCellKey& key) const;
  /// Length of the yarn's axis in the cell, mm.
  double axisLength_mm(const YarnCellKey& key) const;

  /// Whether cells of the same codes have the same fibres.
  bool sameShapes(const YarnTable& other) const;
  /// Where threads are of one kind here just where they are in `other`, and cells of one shape likewise: whatever the
  /// yarns have become, a map of the other's shapes is one of these. Nothing where they are not.
  std::optional<KindNames> namesOfKinds(const YarnTable& other) const;

 private:
  struct SystemYarns {
    std::vector<YarnGeometry> outlines;                    ///< per geometry class, without fibres
    std::vector<std::shared_ptr<const YarnModel>> models;  ///< per geometry class; null where the system has none
    std::vector<int> sequence;                             ///< Fabric::yarns index per end or pick
    ThreadKinds threads;
  };
  const SystemYarns& of(System system) const { return systems_[static_cast<size_t>(system)]; }
  PathNode node(System system, int own, const CellShape::Node& at) const;
  ThreadKinds spaced(System system, const std::vector<int>& classes, const std::vector<int>& crossed,
                     const std::vector<double>& spacing) const;
  /// visit(state, otherState): of the float states that a yarn and the one it crosses may be in at a crossing.
  template <class Visit>
  void forEachState(const Visit& visit) const {
    for (int state = 0; state < kFloatStates; ++state)
      for (int otherState = 0; otherState < kFloatStates; ++otherState)
        if (crowded_ || otherState == state) visit(state, otherState);
  }
  bool sameNodes(const YarnTable& other) const;
  std::vector<int> nodeGroups(System system, int own, const std::vector<int>& crossed) const;
  std::vector<int> leaningGroups(System system, int own) const;
  void resolve(const Fabric& fabric, const YarnTable* previous, bool sketched, const Task& task);
  void findThickness();

  std::array<SystemYarns, 2> systems_;
  std::vector<Crossing> crossings_;  ///< warp class * classCount + weft class
  int classCount_ = 0;
  bool crowded_ = false;
  double warpPitch_mm_ = 0, weftPitch_mm_ = 0, halfThickness_mm_ = 0;
  Tiling tiling_;
};

}  // namespace loomlight
