#include "core/fabric/model/colourways.h"

#include <algorithm>

namespace loomlight {

Colourway colourwayOf(const Fabric& fabric, std::string name) {
  Colourway colourway;
  colourway.name = std::move(name);
  for (const Fibre& fibre : fabric.fibres) colourway.absorption_per_mm.push_back(fibre.absorption_per_mm);
  return colourway;
}

Fabric inColourway(Fabric fabric, const Colourway& colourway) {
  const size_t count = std::min(fabric.fibres.size(), colourway.absorption_per_mm.size());
  for (size_t i = 0; i < count; ++i) fabric.fibres[i].absorption_per_mm = colourway.absorption_per_mm[i];
  return fabric;
}

}  // namespace loomlight
