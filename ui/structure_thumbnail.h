#pragma once

#include <optional>
#include <string>

#include "core/fabric/draft_edit.h"
#include "core/fabric/structures.h"
#include "core/fabric/weave_edit.h"
#include "ui/ui.h"

namespace loomlight {

/// Point paper of a weave, `cells` crossings a side.
void drawThumbnail(Ui& ui, const Weave& weave, ImVec2 min, float size, int cells);
/// A square to click, that rings what is `chosen`; its tooltip is the structure's name.
bool structureThumbnail(Ui& ui, const std::string& id, const Structure& structure, float size, int cells, bool chosen);

/// The fabric with the structure in the selection, or in place of its weave where nothing is selected.
Rewoven withStructure(const Fabric& fabric, const std::optional<CellRect>& selection, const Weave& structure,
                      const LoomLimits& limits);

}  // namespace loomlight
