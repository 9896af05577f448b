#pragma once

#include <optional>
#include <vector>

#include "ui/draft/draft_canvas.h"

namespace loomlight {

/// The draft with its colour bars; below it structures to start from, the loom, and the order of colours. `brushYarn`:
/// what a click on a colour bar paints. `floats`: the long ones, null while they are counted.
std::optional<Fabric> draftPanel(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, int brushYarn,
                                 const LongFloats* floats, DraftPreferences& preferences, DraftView& view,
                                 std::optional<CrossingIndex> lit);

// The pages; each returns the fabric after an edit.
std::optional<Fabric> structurePage(Ui& ui, const Fabric& fabric, const DraftPreferences& preferences, DraftView& view);
std::optional<Fabric> loomPage(Ui& ui, const Fabric& fabric, DraftPreferences& preferences, DraftView& view);
std::optional<Fabric> orderPage(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, DraftView& view);

}  // namespace loomlight
