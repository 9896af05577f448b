#pragma once

#include "render/transport/path_length_tally.h"

namespace loomlight {

/// Light is traced through a cloth until its colour is known this well, by colourError(): where a measured swatch is to
/// be matched; where a colour is told, judged or was only picked, which costs a quarter of it; and where somebody waits
/// for the answer, a seventh.
inline constexpr double kDyeError = 0.15, kToldError = 0.3, kLiveDyeError = 0.4;
/// So many paths at first, which tell how many it takes; and at the most.
inline constexpr size_t kFirstDyePaths = 8192, kMostDyePaths = 32 * kFirstDyePaths;

/// How well paths tell a colour: its standard error, as the root of the mean square of CIEDE2000, at the worst of greys
/// and colours whose darkest channel has from all to a sixteenth of the undyed cloth's light, or as little as surfaces
/// mirror. Dark and deep ones are known least, as few paths show them.
double colourError(const PathLengthTally& paths);

/// Paths that judge are not those that a dye was solved with: those fit it better than the cloth does.
enum class DyePaths { toSolve, toJudge };

/// As many paths as tell the colour of a part of the cloth to this error, whatever its dyes; fewer where kMostDyePaths
/// do not, and where the part is hardly ever met first. nullopt when stopped.
std::optional<PathLengthTally> tracePathsForDyes(const Scene& scene, const Medium& medium, const ClothPart& part,
                                                 const Task& task, DyePaths use = DyePaths::toSolve,
                                                 double error = kDyeError);
/// The same through a patch of the fabric that is made for it. Throws InputError for files that cannot be used.
std::optional<PathLengthTally> tracePathsForDyes(const Fabric& fabric, const ClothPart& part, const Task& task,
                                                 DyePaths use = DyePaths::toSolve, double error = kDyeError);

}  // namespace loomlight
