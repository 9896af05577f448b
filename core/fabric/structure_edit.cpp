#include "core/fabric/structure_edit.h"

namespace loomlight {

Rewoven withStructure(const Fabric& fabric, const std::optional<CellRect>& selection, const Weave& structure,
                      const LoomLimits& limits) {
  return rewoven(fabric, selection ? withPattern(fabric.weave, *selection, structure) : structure, limits);
}

Rewoven withStructure(const Fabric& fabric, const std::optional<CellRect>& selection, const MadeStructure& structure,
                      const LoomLimits& limits) {
  Rewoven result = withStructure(fabric, selection, structure.weave, limits);
  if (structure.warpColours.empty()) return result;
  Fabric& woven = result.fabric;
  if (woven.yarns.size() == 1) woven.yarns.push_back(woven.yarns.front());
  woven.warpSequence = structure.warpColours;
  woven.weftSequence = structure.weftColours;
  return result;
}

}  // namespace loomlight
