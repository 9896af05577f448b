#pragma once

#include <optional>
#include <vector>

#include "ui/draft/draft_view.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// Draws the draft with its colour bars into the rectangle, and lets the mouse paint all of it. `yarnColours`: display
/// colour of each yarn. `brushYarn`: what a click on a bar paints. `lit`: the crossing under the mouse in the viewport.
/// Returns the fabric after a stroke's step; what that did to the draft is in `view.remark`.
std::optional<Fabric> draftCanvas(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, int brushYarn,
                                  const DraftPreferences& preferences, DraftView& view,
                                  std::optional<CrossingIndex> lit, ImVec2 size);

}  // namespace loomlight
