#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {

/// What the yarns of a fabric are called, here as in the editor: each by the name that somebody gave it, or where that
/// is empty by its count and the colour that the cloth reaches with it (coloursForNames()). Light is traced through the
/// cloth for that, but only where a yarn has no name. nullopt when stopped before it was known.
std::optional<std::vector<std::string>> yarnNames(const Fabric& fabric, const Task& task,
                                                  CountSystem system = CountSystem::tex);

}  // namespace loomlight
