#pragma once

#include <optional>
#include <vector>

#include "ui/draft_view.h"
#include "ui/ui.h"

namespace loomlight {

/// Draws the weave and its colour bars into the rectangle and lets the mouse paint them. `yarnColours`: display colour
/// of each yarn. `lit`: the crossing under the mouse in the viewport. Returns the fabric after a stroke's step.
std::optional<Fabric> draftCanvas(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, DraftView& view,
                                  std::optional<CrossingIndex> lit, ImVec2 size);

/// The drawing alone; clipped to what is visible, whatever the size of the weave.
void drawWeave(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, const DraftFrame& frame,
               bool inColour);

}  // namespace loomlight
