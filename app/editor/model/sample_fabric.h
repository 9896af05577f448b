#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The sample cloths that travel inside the program, by name: some of our own, then the wardrobe. The first is what a
/// new editor opens on.
std::vector<std::string> sampleNames();
/// index < sampleNames().size()
Fabric sampleFabric(size_t index = 0);

/// What somebody sees who starts the editor for the first time: a hand's breadth of denim in folds at a window, where
/// it looks like cloth and the wheel leads down to its fibres.
Fabric welcomeFabric();
/// A hand's breadth of a plain cloth that nobody has named or described yet.
Fabric newFabric();

}  // namespace loomlight
