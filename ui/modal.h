#pragma once

#include "ui/ui.h"

namespace loomlight {

/// A dialog, which is open, in the middle of the window, where it keeps the rest waiting. `opening`: it appears in this
/// frame; false from then on. A height of 0 fits the content. When true, content follows and endModal() closes the
/// scope; when false it has been closed, and `open` says so.
bool beginModal(Ui& ui, const char* title, ImVec2 size, bool& open, bool& opening);
void endModal();
/// Escape, outside of a text field.
bool modalCancelled();
/// The last line of a dialog: its button, or Escape. True when it closes.
bool closedBelow(Ui& ui, const char* id);

}  // namespace loomlight
