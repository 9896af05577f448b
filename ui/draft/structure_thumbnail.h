#pragma once

#include <string>

#include "core/fabric/weave/structures.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// Point paper of a weave, `cells` crossings a side.
void drawThumbnail(Ui& ui, const Weave& weave, ImVec2 min, float size, int cells);
/// A square to click, that rings what is `chosen`; its tooltip is the structure's name.
bool structureThumbnail(Ui& ui, const std::string& id, const Structure& structure, float size, int cells, bool chosen);

}  // namespace loomlight
