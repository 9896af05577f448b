#pragma once

#include <vector>

#include "ui/draft/draft_layout.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// The drawdown, clipped to what is visible, whatever the size of the weave. `floatLimit_mm` marks what floats longer
/// than it, on the face or on the back; 0 marks nothing.
void drawWeave(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, const DraftFrame& frame,
               bool inColour, double floatLimit_mm);
/// The yarn of each end above the weave, of each pick beside it.
void drawBar(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& yarnColours, const DraftFrame& frame,
             System system, const Box& bar);
/// Lengths along the cloth.
void drawRuler(Ui& ui, const Fabric& fabric, const DraftFrame& frame, System along, bool inches, const Box& ruler);
/// A float that is looked at.
void ringFloat(Ui& ui, const DraftFrame& frame, const FloatRun& run);
void ringCrossing(Ui& ui, const DraftFrame& frame, const CrossingIndex& crossing);
void drawSelection(Ui& ui, const DraftFrame& frame, const CellRect& selection);

}  // namespace loomlight
