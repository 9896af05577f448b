#pragma once

#include <string>

#include "ui/inspector/cloth_colour.h"

namespace loomlight {

/// The largest difference that passes.
void toleranceField(Ui& ui, const char* id, double& tolerance_cmc);
/// What is said of a difference beside it.
std::string verdictText(double cmc, double tolerance_cmc);

/// Whether the cloth passes beside what is wanted: under its own lamp, and under the worst of the booth. Rows of a
/// fixed height, whatever is known.
void toleranceRows(Ui& ui, const ClothColourModel& model, double& tolerance_cmc);

}  // namespace loomlight
