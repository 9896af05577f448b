#include "ui/dialogs/preferences_dialog.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"

namespace loomlight {

namespace {

void lookRows(Ui& ui, bool& darkTheme, float& interfaceSize) {
  heading(ui, "Look");
  static constexpr const char* kThemes[] = {"Dark", "Light"};
  int theme = darkTheme ? 0 : 1;
  segmentField(ui, {"preferences.theme", "Theme", "The cloth is seen on the same grey in both."}, kThemes, theme);
  darkTheme = theme == 0;
  static constexpr const char* kNames[] = {"75 %", "100 %", "125 %", "150 %", "200 %"};
  static_assert(std::size(kNames) == std::size(kInterfaceSizes));
  const auto nearest = std::min_element(std::begin(kInterfaceSizes), std::end(kInterfaceSizes), [&](float a, float b) {
    return std::abs(a - interfaceSize) < std::abs(b - interfaceSize);
  });
  int size = static_cast<int>(nearest - std::begin(kInterfaceSizes));
  if (segmentField(ui,
                   {"preferences.size", "Size of the interface",
                    "100 % is what the monitor asks for. A small window holds it to what leaves room for the cloth."},
                   kNames, size))
    interfaceSize = kInterfaceSizes[size];
}

}  // namespace

void PreferencesDialog::draw(Ui& ui, double machine_GB, PreferenceValues values) {
  if (!open_ || !beginModal(ui, "Preferences", ImVec2(ui.px(560), 0), open_, opening_)) return;
  lookRows(ui, values.darkTheme, values.interfaceSize);
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
