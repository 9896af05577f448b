#pragma once

#include <cstdint>

#include "core/fabric/model/fabric.h"
#include "core/geometry/yarn/yarn_path.h"

namespace loomlight {

/// All that the fibres of one yarn in one crossing cell depend on, and nothing more: equal keys have equal fibres,
/// voxel for voxel. Colour and optics are not in it.
struct YarnCellKey {
  System system = System::warp;
  int yarn = 0;     ///< geometry class of the yarn: equal for yarns that differ only in colour
  int phase = 0;    ///< where in the yarn's own period this cell lies, 0 <= phase < YarnGeometry::period
  int stretch = 0;  ///< of an uneven yarn, the kind of stretch that the cell lies in (Spool::kind); else 0
  PathNode previous, here, next;
  bool operator==(const YarnCellKey&) const = default;
};
uint64_t hash(const YarnCellKey& key);
/// For the standard library's tables.
struct YarnCellKeyHash {
  size_t operator()(const YarnCellKey& key) const { return hash(key); }
};

}  // namespace loomlight
