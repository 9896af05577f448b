#pragma once

#include <string>

#include "ui/draft/draft_view.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// How long floats may be, those that are longer as a list, and the next and the one before: the chosen one is brought
/// into sight. `floats`: null while they are counted.
void floatRow(Ui& ui, const LongFloats* floats, DraftPreferences& preferences, DraftView& view);

/// Where it lies and how long it is: "weft float, pick 3, ends 5 to 13: 2.1 mm, back".
std::string floatText(const FloatRun& run);

}  // namespace loomlight
