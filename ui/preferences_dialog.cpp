#include "ui/preferences_dialog.h"

#include <algorithm>

#include "ui/fields.h"
#include "ui/modal.h"

namespace loomlight {

void PreferencesDialog::draw(Ui& ui, double machine_GB, PreferenceValues values) {
  if (!open_ || !beginModal(ui, "Preferences", ImVec2(ui.px(480), 0), open_, opening_)) return;
  heading(ui, "Units");
  countSystemRow(ui, "preferences", values.units.count);
  twistUnitRow(ui, "preferences", values.units.twistAsMultiplier);
  static constexpr const char* kLengths[] = {"cm", "inch"};
  int length = values.draft.inches ? 1 : 0;
  segmentField(ui, {"preferences.lengths", "Lengths in", "Of rulers, setts and repeats."}, kLengths, length);
  values.draft.inches = length == 1;
  heading(ui, "The usual piece");
  pieceSizeRows(ui, "preferences", values.units.piece);
  heading(ui, "Truth lens");
  NumberStyle memory;
  memory.unit = "GB";
  memory.min = 0.1;
  memory.max = std::max(memory.min, machine_GB);
  memory.decimals = 1;
  numberField(ui,
              {"preferences.fibre_memory", "Memory at most",
               "The lens lays every single fibre of the piece. Where that would take more memory than this, it says so "
               "and leaves it."},
              memory, values.fibreMemory_GB);
  if (closedBelow(ui, "preferences.close")) open_ = false;
  endModal();
}

}  // namespace loomlight
