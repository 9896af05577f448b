#pragma once

#include "ui/widgets/ui.h"

namespace loomlight {

/// A dialog, which is open, in the middle of the window, where it keeps the rest waiting. `opening`: it appears in this
/// frame; false from then on. A height of 0 fits the content. When true, content follows and endModal() closes the
/// scope; when false it has been closed, and `open` says so.
bool beginModal(Ui& ui, const char* title, ImVec2 size, bool& open, bool& opening);
/// The same of a dialog that ends by its own buttons alone: where another has shut it, it comes back.
bool beginLastingModal(Ui& ui, const char* title, ImVec2 size, bool& open, bool& opening);
void endModal();
/// The height that is left for what stands between here and a last line of buttons, in a dialog that fits its content:
/// in a low window that part scrolls, and the buttons stay in sight.
float roomAboveButtons(const Ui& ui);
/// The rows between a dialog's heading and its last line of buttons, in a dialog that fits its content: as high as they
/// are, or in a low window as high as there is room, and then they scroll. `below`: the height, in pixels, of what
/// stands between them and the buttons.
void beginModalRows(const Ui& ui, const char* id, float below = 0);
void endModalRows(const char* id);
/// Escape, unless a list that is open in the dialog or a number that is being typed takes it. In a line of text, which
/// it leaves, it closes the dialog all the same.
bool modalCancelled(const Ui& ui);
/// Enter, outside of a text or a list: the button that stands out.
bool modalConfirmed(const Ui& ui);
/// Closes the dialog that is drawn. endModal() follows all the same.
void closeModal(bool& open);
/// The last line of a dialog that has nothing but its close button there; Escape and Enter close it too.
void closeButtonBelow(Ui& ui, const char* id, bool& open);

}  // namespace loomlight
