#pragma once

#include <optional>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "render/transport/path_length_tally.h"

namespace loomlight {

/// tallyPathLengths() through a patch of the fabric that is made for it; nullopt when stopped. `part`: that is met
/// first. Throws InputError for files that cannot be used.
std::optional<PathLengthTally> walkThrough(const Fabric& fabric, const ClothPart& part, size_t count, const Task& task);

}  // namespace loomlight
