#pragma once

#include <string>

namespace loomlight {

/// loomlight bench cloths: mass and thickness of the wardrobe's cloths, the trade's and ours, and the area that
/// their yarns cover, round and as they are pressed.
struct ClothsBenchCommand {
  std::string folder;  ///< where page and tables go
};

/// The table on stdout, too. Exit status 0. Throws InputError.
int run(const ClothsBenchCommand& command);

}  // namespace loomlight
