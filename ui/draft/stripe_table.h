#pragma once

#include <optional>
#include <vector>

#include "ui/widgets/ui.h"

namespace loomlight {

/// The stripes of an order, each with its yarn, threads and width, which can be set either way. `pitch_mm`: between
/// threads. Returns the order after an edit.
std::optional<std::vector<int>> stripeTable(Ui& ui, const std::vector<int>& sequence,
                                            const std::vector<ImVec4>& yarnColours, double pitch_mm);

}  // namespace loomlight
