#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/ui.h"

namespace loomlight {

struct PresetChoice {
  bool isSample = false;
  size_t index = 0;  ///< in the list it is from
};

/// The cloths kept at hand: the designer's own, then those that came with the program. Returns the one that was
/// clicked.
std::optional<PresetChoice> presetList(Ui& ui, const std::vector<std::string>& own,
                                       const std::vector<std::string>& samples);

}  // namespace loomlight
