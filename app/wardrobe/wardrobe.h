#pragma once

#include <span>
#include <string_view>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// How far a figure of ours may be from the trade's, as a share of it; and why, where that is more than usual.
struct Allowance {
  double share = 0;
  const char* reason = "";
};
inline constexpr Allowance kMassAllowance{0.05}, kThicknessAllowance{0.20};

/// What the trade says of a finished cloth.
struct TradeFigures {
  const char* construction;  ///< counts of warp x weft / ends x picks to the inch, or as that trade quotes it
  double mass_g_m2 = 0;
  double thickness_mm = 0;  ///< as a gauge feels it, under about 1 kPa
  const char* source;       ///< of construction, mass and thickness: read where, or recalled
  Allowance thickness = kThicknessAllowance;
};

/// A cloth that is bought by its name, from samples/cloths.
struct WardrobeCloth {
  const char* file;  ///< without folder and ending
  const char* name;  ///< as in the file
  const std::string_view& json;
  TradeFigures trade;
};

/// Shirtings, denims, wools, linen, silks, linings, household cloths, in that order. They travel inside the program.
std::span<const WardrobeCloth> wardrobe();

Fabric fabricOf(const WardrobeCloth& cloth);
/// The cloth of that file's name, which must be one of the wardrobe's.
Fabric wardrobeFabric(std::string_view file);

}  // namespace loomlight
