#pragma once

#include <span>
#include <vector>

#include "render/colour/tristimulus.h"
#include "render/transport/path_length_tally.h"

namespace loomlight {

/// How to dye a fibre, or several alike, so that the cloth shows a colour.
struct SolvedColour {
  Rgb absorption_per_mm{0};  ///< of each of them
  Rgb reached{0};            ///< what the cloth then shows, where the paths begin
  bool tooLight = false;     ///< wanted is lighter, in some channel, than the cloth is undyed: light comes through
  bool tooDark = false;      ///< wanted is darker, in some channel, than what fibres mirror from their surfaces
};

/// The one absorption of the `dyed` materials, in three numbers, with which the paths give the wanted colour (linear, 1
/// is white paper), those of all others as they are in `colouring`, by its eye; where a channel cannot be reached, the
/// one that looks nearest (nearestColour()) of all that can. `paths` are of light that met a dyed material first, and
/// some of them came back to the sky.
SolvedColour solveColour(const PathLengthTally& paths, Colouring colouring, std::span<const int> dyed,
                         const Rgb& wanted);

/// How they absorb in each band, where the cloth reflects as measured.
struct SolvedReflectance {
  Spectrum absorption_per_mm{};      ///< of each of them
  Spectrum reached{};                ///< what the cloth then reflects, where the paths begin
  size_t tooLight = 0, tooDark = 0;  ///< bands in which wanted lies beyond what this cloth can reflect
};

/// The same band by band, for a reflectance as a spectrophotometer measures it. Where a band cannot be reached, all are
/// what looks nearest to it (nearestReflectance()) under `lamp`.
SolvedReflectance solveReflectance(const PathLengthTally& paths, Colouring colouring, std::span<const int> dyed,
                                   const Spectrum& wanted, const TristimulusWeights& lamp);

}  // namespace loomlight
