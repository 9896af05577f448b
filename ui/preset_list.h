#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/ui.h"

namespace loomlight {

/// The cloths kept at hand; returns the one that was clicked.
std::optional<std::string> presetList(Ui& ui, const std::vector<std::string>& names);

}  // namespace loomlight
