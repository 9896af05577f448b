#pragma once

#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A piece as it is ordered, off the loom.
struct PieceSize {
  double length_m = 10;   ///< along the warp
  double width_cm = 150;  ///< along the weft, between the selvedges
};
inline constexpr double kPieceLength_m[] = {0.01, 100'000}, kPieceWidth_cm[] = {0.1, 10'000};  ///< from, to

/// How much of one yarn goes into a piece, loom waste not counted.
struct YarnNeed {
  double warp_m = 0, weft_m = 0;
  double mass_kg = 0;
};

/// Of every yarn of the fabric: its ends and picks, counted along the sequences from the first end and pick, each as
/// long as the piece and its crimp (ClothMeasures); and the ends of its selvedges.
std::vector<YarnNeed> yarnNeed(const Fabric& fabric, const PieceSize& piece, double crimpWarp, double crimpWeft);

}  // namespace loomlight
