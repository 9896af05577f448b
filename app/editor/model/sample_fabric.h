#pragma once

#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// The sample cloths that travel inside the program, by name: some of our own, then the wardrobe.
std::vector<std::string> sampleNames();
/// index < sampleNames().size()
Fabric sampleFabric(size_t index = 0);

/// What the editor opens on where it is given no file: a hand's breadth of denim in folds at a window, where
/// it looks like cloth and the wheel leads down to its fibres.
Fabric welcomeFabric();
/// A hand's breadth of a twill of spun cotton that nobody has named or described yet.
Fabric newFabric();

}  // namespace loomlight
