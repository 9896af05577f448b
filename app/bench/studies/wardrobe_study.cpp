#include "app/bench/studies/wardrobe_study.h"

namespace loomlight {

ClothComparison compareWithTrade(const WardrobeCloth& cloth) {
  ClothComparison comparison{&cloth, fabricOf(cloth), {}, {}};
  const Fabric& fabric = comparison.fabric;
  const ClothGeometry one(fabric, 1, 1);
  const ClothGeometry repeat(fabric, one.repeatEnds(), one.repeatPicks(), &one);
  comparison.ours = repeat.measure();
  comparison.round = coverFactors(fabric);
  return comparison;
}

}  // namespace loomlight
