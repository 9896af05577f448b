#pragma once

#include <optional>
#include <string>

#include "core/fabric/model/fabric.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// So much cloth, lying flat and seen straight from above: as many repeats of the pattern each way (of one that is
/// less than half as long as it is wide, or as wide as long, as many as make the piece square), or centimetres.
struct FlatCloth {
  bool inRepeats = true;
  double count = 1;
  bool operator==(const FlatCloth&) const = default;
};
struct FlatPiece {
  glm::dvec2 size_mm{0.0};  ///< width and height, as far as a piece can be so large
  glm::dvec2 repeats{0.0};  ///< of the pattern, across and along; 0 where it is measured in centimetres
};
FlatPiece pieceOf(const Fabric& fabric, const FlatCloth& cloth);
std::string flatPieceText(const Fabric& fabric, const FlatCloth& cloth);

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
