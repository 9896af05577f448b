#pragma once

#include <optional>

#include "ui/draft/draft_view.h"

namespace loomlight {

/// What is asked of the draft from menus and keys.
enum class DraftCommand {
  // Edits of the selection, or of the whole repeat where nothing is selected:
  copy,
  cut,
  paste,
  fillWithCopy,
  clear,
  invert,
  mirrorEnds,
  mirrorPicks,
  quarterTurn,
  shiftLeft,
  shiftRight,
  shiftUp,
  shiftDown,
  repeatSelection,
  // Of the view alone:
  selectAll,
  selectNothing,
  showBack,
  markFloats,
  // Left to the editor, which has dialogs and files:
  structures,
  fromPicture,
  exportWif,
  exportBitmap,
  exportDraft,
  exportTile,
};

/// What the keyboard asks for in this frame; keys are left alone while text is typed.
std::optional<DraftCommand> draftKey(const DraftView& view);

/// Edits the fabric or the view. Pictures of weaves go over the clipboard as text, so that they can come from another
/// window. Nothing for what does not change the fabric.
std::optional<Fabric> runDraftCommand(DraftCommand command, const Fabric& fabric, const DraftPreferences& preferences,
                                      DraftView& view);

}  // namespace loomlight
