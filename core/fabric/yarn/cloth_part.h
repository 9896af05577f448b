#pragma once

#include <compare>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// What of a cloth is dyed, or looked at where it lies on top: the piece after it was woven, one yarn, or one fibre in
/// whichever yarns it is spun into.
struct ClothPart {
  enum class Kind { piece, yarn, fibre };
  Kind kind = Kind::piece;
  int index = 0;  ///< of the yarn or the fibre
  friend auto operator<=>(const ClothPart&, const ClothPart&) = default;
};
inline ClothPart wholePiece() {
  return {};
}
inline ClothPart partOfYarn(int yarn) {
  return {ClothPart::Kind::yarn, yarn};
}
inline ClothPart partOfFibre(int fibre) {
  return {ClothPart::Kind::fibre, fibre};
}

/// Whether the fabric has it.
bool has(const Fabric& fabric, const ClothPart& part);

/// The fibres that are dyed with it, all alike, ascending.
std::vector<int> fibresOf(const Fabric& fabric, const ClothPart& part);

/// The fabric in which no yarn but that one takes the dye: fibres that others are spun of too become its own, in every
/// colourway. Where there is no room for more fibres, others are dyed with it. All else is ready as it is.
Fabric readyToDye(Fabric fabric, const ClothPart& part);

}  // namespace loomlight
