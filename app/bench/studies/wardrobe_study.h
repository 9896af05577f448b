#pragma once

#include "app/wardrobe/wardrobe.h"
#include "core/fabric/yarn/derived.h"
#include "core/geometry/cloth/cloth_geometry.h"

namespace loomlight {

/// A cloth as ours turns out, beside what the trade says of it.
struct ClothComparison {
  const WardrobeCloth* cloth = nullptr;
  Fabric fabric;
  ClothMeasures ours;
  CoverFactors round;  ///< Peirce's, of our counts and setts: no figure of the trade's

  /// How far ours is from the trade's, as a share of it.
  double massOff() const { return ours.arealMass_g_m2 / cloth->trade.mass_g_m2 - 1; }
  double thicknessOff() const { return ours.thickness_mm / cloth->trade.thickness_mm - 1; }
};

ClothComparison compareWithTrade(const WardrobeCloth& cloth);

}  // namespace loomlight
