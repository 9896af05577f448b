#pragma once

#include <optional>
#include <string>

#include "core/fabric/model/fabric.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// So much cloth, lying flat and seen straight from above: as many repeats of the pattern each way, or centimetres.
struct FlatCloth {
  bool inRepeats = true;
  double count = 1;
  bool operator==(const FlatCloth&) const = default;
};
/// Width and height, as far as a piece can be so large.
glm::dvec2 pieceOf_mm(const Fabric& fabric, const FlatCloth& cloth);
std::string flatClothText(const FlatCloth& cloth);

/// What the menu offers beside a single repeat.
struct FlatMenuModel {
  int repeats = 4;
  double side_cm = 10;
  bool isFlat = false;  ///< it is looked at so now
};
struct FlatMenuChoice {
  std::optional<FlatCloth> cloth;
  bool asDraped = false;  ///< back to the cloth on its drape
};
FlatMenuChoice flatMenu(Ui& ui, const FlatMenuModel& model);

}  // namespace loomlight
