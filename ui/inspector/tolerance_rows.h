#pragma once

#include "ui/inspector/cloth_colour.h"

namespace loomlight {

/// Whether the cloth passes beside what is wanted: under its own lamp, and under the worst of the booth. Rows of a
/// fixed height, whatever is known.
void toleranceRows(Ui& ui, const ClothColourModel& model, double& tolerance_cmc);

}  // namespace loomlight
