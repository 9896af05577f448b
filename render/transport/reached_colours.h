#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/transport/path_length_tally.h"

namespace loomlight {

/// How many paths tell the colour of a yarn where it is a chip that shows it: a standard error of 0.7 % of white.
inline constexpr size_t kChipPaths = 4096;

/// Light traced through a cloth for each of its yarns, from those paths that met it first: they tell what it shows in
/// any dye and under any lamp. A yarn that the face hardly shows, or that no end or pick uses, is traced through as
/// plain cloth of it alone at the same sett. `shared` (may be null): a scene whose parts may be used again, and the new
/// one. nullopt when stopped. Throws InputError for files that cannot be used.
std::optional<std::vector<PathLengthTally>> tracePathsToYarns(const Fabric& fabric, size_t count, const Task& task,
                                                              std::shared_ptr<const Scene>* shared = nullptr);

/// The colour that the cloth reaches where each yarn lies on top, linear, 1 is white paper: seen from straight above in
/// white light from all of the sky. Of a dark yarn it is darker than its dye is in a thick mass, and what lies beneath
/// shines through.
std::vector<Rgb> reachedColours(const std::vector<PathLengthTally>& paths, const Colouring& colouring);

/// The colours by which the yarns are called: an eye that has only this cloth takes for white what its undyed yarns
/// would reach, and calls no white voile grey because black shines through.
std::vector<Rgb> coloursForNames(const std::vector<PathLengthTally>& paths, std::vector<Rgb> reached);

/// reachedColours() under the fabric's lamps and for its observer. nullopt when stopped.
std::optional<std::vector<Rgb>> reachedColours(const Fabric& fabric, const Task& task, size_t paths = kChipPaths);

/// The same in a moment, for small pictures of files: of coarse voxels and few paths.
std::optional<std::vector<Rgb>> soonReachedColours(Fabric fabric, const Task& task);

}  // namespace loomlight
