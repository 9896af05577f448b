#pragma once

#include <optional>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/transport/path_length_tally.h"

namespace loomlight {

/// tallyPathLengths() through a patch of the fabric that is made for it; nullopt when stopped. `material`: that is met
/// first, or kAnyMaterial. Throws InputError for files that cannot be used.
std::optional<PathLengthTally> walkThrough(const Fabric& fabric, int material, size_t count, const Task& task);

}  // namespace loomlight
