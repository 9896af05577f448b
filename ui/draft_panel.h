#pragma once

#include <optional>
#include <vector>

#include "ui/draft_canvas.h"

namespace loomlight {

/// Point paper with its colour bars, the size of the repeat, the order of colours, and structures to start from.
std::optional<Fabric> draftPanel(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, DraftView& view,
                                 std::optional<CrossingIndex> lit);

}  // namespace loomlight
