#include "core/fabric/yarn/dyeing.h"

#include <utility>

#include "core/fabric/yarn/yarn_edit.h"

namespace loomlight {

std::string nameOnceDyed(const Fabric& fabric, int fibre) {
  const std::string& name = fabric.fibres[static_cast<size_t>(fibre)].name;
  return name.find(", ") == std::string::npos ? name : fibreNameFor(fabric, kindName(name));
}

Fabric dyedAlike(Fabric ready, const ClothPart& part, const Absorption& absorption) {
  for (const int index : fibresOf(ready, part)) {
    std::string name = nameOnceDyed(ready, index);
    Fibre& fibre = ready.fibres[static_cast<size_t>(index)];
    fibre.name = std::move(name);
    fibre.absorption_per_mm = absorption;
  }
  return ready;
}

}  // namespace loomlight
