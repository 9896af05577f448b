#pragma once

#include <optional>

#include "ui/draft/draft_layout.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// Threading, tie-up and treadling (or liftplan) beside the drawdown: drawn, and painted with the mouse. An end hangs
/// on one shaft and a pick presses one treadle, unless Ctrl adds another. Returns the draft after a stroke's step.
std::optional<Draft> draftParts(Ui& ui, const Draft& draft, DraftView& view, const DraftFrame& frame,
                                const DraftLayout& layout);

/// The line and number of a part under the mouse, for the line that says so; empty beside all parts.
std::string partUnderMouse(const Draft& draft, const DraftFrame& frame, const DraftLayout& layout);

}  // namespace loomlight
