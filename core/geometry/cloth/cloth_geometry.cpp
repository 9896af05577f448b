#include "core/geometry/cloth/cloth_geometry.h"

#include <fmt/format.h>

#include <cassert>

namespace loomlight {

ClothGeometry::ClothGeometry(const Fabric& fabric, int ends, int picks, const ClothGeometry* previous, bool sketched,
                             const Task& task, const Tiling& tiling)
    : yarns_(fabric, previous ? &previous->yarns_ : nullptr, sketched, task, tiling),
      codes_(fabric.weave, {yarns_.threads(System::warp).sequence, yarns_.threads(System::weft).sequence},
             fabric.crowding > 0),
      ends_(ends),
      picks_(picks) {
  assert(ends >= 1 && picks >= 1);
}

YarnCellKey ClothGeometry::key(System system, int pick, int end) const {
  ShapeCode code{};
  codes_.read(system, system == System::warp ? end : pick, system == System::warp ? pick : end, {&code, 1});
  YarnCellKey key = shapeKey(system, code);
  const YarnTable::Place at = place(system, pick, end);
  key.phase = at.phase;
  if (const auto& spool = yarns_.spool(system, key.yarn)) key.stretch = spool->kind(at.stretch);
  return key;
}

YarnTable::Place ClothGeometry::place(System system, int pick, int end) const {
  const int along = system == System::warp ? pick : end, across = system == System::warp ? end : pick;
  return yarns_.place(system, geometryClass(system, across), across, along);
}

std::vector<std::string> ClothGeometry::spacingRemarks() const {
  std::vector<std::string> remarks;
  for (const System system : {System::warp, System::weft})
    if (const double share = yarns_.threads(system).share; share < 0.995)
      remarks.push_back(fmt::format("The {} lie unevenly by {:.0f} % of what is asked, which is as far as they can.",
                                    system == System::warp ? "ends" : "picks", 100 * share));
  return remarks;
}

bool ClothGeometry::differsInWeaveOnly(const ClothGeometry& other) const {
  return ends_ == other.ends_ && picks_ == other.picks_ && yarns_.sameShapes(other.yarns_);
}

}  // namespace loomlight
