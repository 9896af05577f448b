#include "core/fabric/weave/structure_edit.h"

#include <utility>

#include "core/fabric/model/validate.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_edit.h"
#include "core/fabric/yarn/yarn_reflectance.h"

namespace loomlight {

Rewoven withStructure(const Fabric& fabric, const std::optional<CellRect>& selection, const Weave& structure,
                      const LoomLimits& limits) {
  return rewoven(fabric, selection ? withPattern(fabric.weave, *selection, structure) : structure, limits);
}

Fabric withSecondYarn(Fabric fabric) {
  if (fabric.yarns.size() != 1) return fabric;
  Yarn yarn = fabric.yarns.front();
  Fibre fibre = fabric.fibres[static_cast<size_t>(yarn.fibre)];
  const Rgb shown = fibreReflectance(fibre);
  constexpr float kMiddleGrey = 0.18f, kDark = 0.03f, kLight = 0.7f;
  const bool isLight = (shown.x + shown.y + shown.z) / 3 > kMiddleGrey;
  if (fabric.fibres.size() < static_cast<size_t>(kMaxKinds)) {
    fibre = dyed(std::move(fibre), Rgb(isLight ? kDark : kLight));
    fibre.name = fibreNameFor(fabric, kindName(fibre.name));
    yarn.name.clear();  // it goes by its colour and count
    yarn.blendFibre.reset();
    yarn.blendShare.reset();
    yarn.fibre = static_cast<int>(fabric.fibres.size());
    fabric.fibres.push_back(std::move(fibre));
  }
  fabric.yarns.push_back(std::move(yarn));
  return fabric;
}

Rewoven withStructure(const Fabric& fabric, const std::optional<CellRect>& selection, const MadeStructure& structure,
                      const LoomLimits& limits) {
  Rewoven result = withStructure(fabric, selection, structure.weave, limits);
  if (structure.warpColours.empty()) return result;
  result.fabric = withSecondYarn(std::move(result.fabric));
  Fabric& woven = result.fabric;
  woven.warpSequence = structure.warpColours;
  woven.weftSequence = structure.weftColours;
  return result;
}

}  // namespace loomlight
