#pragma once

#include <span>

#include "ui/widgets/ui.h"

namespace loomlight {

/// A button that is on or off, as wide as its name needs. True when it changed.
bool toggleButton(Ui& ui, const char* id, const char* name, const char* tooltip, bool& on);

/// Pages below a line, each name centred on its share of the width. True when another was opened.
bool pageTabs(Ui& ui, std::span<const char* const> names, std::span<const char* const> ids, int& open);

}  // namespace loomlight
