#pragma once

#include "render/transport/path_length_tally.h"

namespace loomlight {

/// How to dye a fibre so that the cloth shows a colour.
struct SolvedColour {
  Rgb absorption_per_mm{0};  ///< of that fibre
  Rgb reached{0};            ///< what the cloth then shows, where the fibre lies on top
  bool tooLight = false;     ///< wanted is lighter, in some channel, than the cloth is undyed: light comes through
  bool tooDark = false;      ///< wanted is darker, in some channel, than what fibres mirror from their surfaces
};

/// The absorption of `material` with which the walks give the wanted colour (linear, 1 is white paper), those of all
/// other materials as they are; where a channel cannot be reached, the one that looks nearest (nearestColour()) of all
/// that can. `walks` are of light that met `material` first, and some of them came back to the sky.
SolvedColour solveColour(const PathLengthTally& walks, std::vector<Rgb> absorption_per_mm, int material,
                         const Rgb& wanted);

}  // namespace loomlight
