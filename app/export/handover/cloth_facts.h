#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "core/geometry/cloth/cloth_geometry.h"

namespace loomlight {

/// A word of a list that programs agree on; "other" comes with a name of its own, all others without.
struct ListedName {
  std::string type;
  std::string name;  ///< empty where the type says it all
  bool operator==(const ListedName&) const = default;
};

/// A part of a cloth's mass.
struct CompositionPart {
  double ratio = 0;  ///< 0..1; those of a cloth sum to 1
  ListedName fibre;
};

/// By mass, largest first, from the yarns' counts, setts, crimps and blends. Fibres are told by their names, in the
/// words of U3M 1.1: "wool, navy" is Wool; one without such a word is other.
std::vector<CompositionPart> compositionOf(const Fabric& fabric, const ClothMeasures& measures);

/// What weaves are called in U3M 1.1: plain weave, twill to either hand, satin; else dobby, or jacquard where more ends
/// weave differently than shafts can lift. Ribs and baskets are other, by their code of ISO 9354.
ListedName constructionOf(const Weave& weave);

}  // namespace loomlight
