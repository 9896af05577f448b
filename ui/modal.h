#pragma once

#include "ui/ui.h"

namespace loomlight {

/// A dialog in the middle of the window that keeps the rest waiting. `open`: in the frame in which it appears. A height
/// of 0 fits the content. When true, content follows and endModal() closes the scope; false once it has been closed.
bool beginModal(Ui& ui, const char* title, ImVec2 size, bool open);
void endModal();
/// Escape, outside of a text field.
bool modalCancelled();
/// The last line of a dialog: its button, or Escape. True when it closes.
bool closedBelow(Ui& ui, const char* id);

}  // namespace loomlight
