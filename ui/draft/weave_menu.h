#pragma once

#include <optional>

#include "ui/draft/draft_commands.h"
#include "ui/widgets/ui.h"

namespace loomlight {

struct WeaveMenuModel {
  bool selection = false;  ///< something is selected
  bool back = false, marksFloats = false;
};

/// As ImGui's, with a name for tests; Esc shuts it.
bool beginMenu(Ui& ui, const char* id, const char* label);
/// The menu of all that is done to a weave; within the menu bar.
std::optional<DraftCommand> weaveMenu(Ui& ui, const WeaveMenuModel& model);
/// What is done to a selection, beside the mouse: opened once, drawn in the same window.
void openSelectionMenu();
std::optional<DraftCommand> selectionMenu(Ui& ui, bool selection);
/// What a cloth can be written as for others; within the file menu.
std::optional<DraftCommand> exportMenu(Ui& ui);

}  // namespace loomlight
