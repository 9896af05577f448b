#pragma once

#include "ui/viewport/viewport_panel.h"

namespace loomlight {

/// What stands on the picture, between `min` and `max`: how the cloth is looked at and shown, what is wrong with it,
/// what is under the mouse, and how far it is built. No label covers another or loses its end: where two do not fit
/// beside each other they stand below each other, and what is wrong is broken into lines.
void viewLabels(Ui& ui, const ViewportModel& model, const InsetView& inset, ImVec2 min, ImVec2 max);

}  // namespace loomlight
