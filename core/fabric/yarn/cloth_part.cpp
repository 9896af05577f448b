#include "core/fabric/yarn/cloth_part.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/fabric/model/validate.h"
#include "core/fabric/yarn/yarn_edit.h"

namespace loomlight {
namespace {

bool isSpunOf(const Yarn& yarn, int fibre) {
  return yarn.fibre == fibre || yarn.blendFibre == fibre;
}

/// A fibre like that one, of the same colour in every colourway. Returns its number.
int copiedFibre(Fabric& fabric, int fibre) {
  Fibre copy = fabric.fibres[static_cast<size_t>(fibre)];
  copy.name = fibreNameFor(fabric, kindName(copy.name));
  return addFibre(fabric, std::move(copy), fibre);
}

}  // namespace

bool has(const Fabric& fabric, const ClothPart& part) {
  const size_t count = part.kind == ClothPart::Kind::piece  ? 1
                       : part.kind == ClothPart::Kind::yarn ? fabric.yarns.size()
                                                            : fabric.fibres.size();
  return part.index >= 0 && static_cast<size_t>(part.index) < count;
}

std::vector<int> fibresOf(const Fabric& fabric, const ClothPart& part) {
  if (part.kind == ClothPart::Kind::fibre) return {part.index};
  if (part.kind == ClothPart::Kind::yarn) {
    const Yarn& yarn = fabric.yarns[static_cast<size_t>(part.index)];
    const auto [first, last] = std::minmax({yarn.fibre, yarn.blendFibre.value_or(yarn.fibre)});
    return first == last ? std::vector{first} : std::vector{first, last};
  }
  std::vector<int> all(fabric.fibres.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Fabric readyToDye(Fabric fabric, const ClothPart& part) {
  if (part.kind != ClothPart::Kind::yarn) return fabric;
  const auto own = static_cast<size_t>(part.index);
  for (const int fibre : fibresOf(fabric, part)) {
    bool isShared = false;
    for (size_t i = 0; i < fabric.yarns.size(); ++i) isShared |= i != own && isSpunOf(fabric.yarns[i], fibre);
    if (!isShared || fabric.fibres.size() >= kMaxKinds) continue;
    const int copy = copiedFibre(fabric, fibre);
    Yarn& yarn = fabric.yarns[own];
    if (yarn.fibre == fibre) yarn.fibre = copy;
    if (yarn.blendFibre == fibre) yarn.blendFibre = copy;
  }
  return fabric;
}

}  // namespace loomlight
