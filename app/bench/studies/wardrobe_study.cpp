#include "app/bench/studies/wardrobe_study.h"

#include <algorithm>

namespace loomlight {
namespace {

/// Of a system alone, over its sequence.
double coverOf(const Fabric& fabric, const ClothGeometry& geometry, System system) {
  const bool warp = system == System::warp;
  const int threads = static_cast<int>((warp ? fabric.warpSequence : fabric.weftSequence).size());
  const double pitch_mm = warp ? geometry.warpPitch_mm() : geometry.weftPitch_mm();
  double covered = 0;
  for (int thread = 0; thread < threads; ++thread) {
    const YarnGeometry& yarn = geometry.yarn(system, geometry.geometryClass(system, thread));
    covered += std::min(1.0, 2 * yarn.halfWidth_mm() / pitch_mm);
  }
  return covered / threads;
}

}  // namespace

ClothComparison compareWithTrade(const WardrobeCloth& cloth) {
  ClothComparison comparison{&cloth, fabricOf(cloth), {}, 0};
  const Fabric& fabric = comparison.fabric;
  const ClothGeometry one(fabric, 1, 1);
  const ClothGeometry repeat(fabric, one.repeatEnds(), one.repeatPicks(), &one);
  comparison.ours = repeat.measure();
  const double warp = coverOf(fabric, repeat, System::warp), weft = coverOf(fabric, repeat, System::weft);
  comparison.cover = warp + weft - warp * weft;
  return comparison;
}

}  // namespace loomlight
