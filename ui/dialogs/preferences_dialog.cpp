#include "ui/dialogs/preferences_dialog.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/dialog_words.h"
#include "ui/words/menu_words.h"
#include "ui/words/trade_words.h"

namespace loomlight {

namespace {

void lookRows(Ui& ui, bool& darkTheme, float& interfaceSize) {
  heading(ui, words::preferences::look);
  static constexpr const char* kThemes[] = {words::menu::darkTheme.label, words::menu::lightTheme.label};
  int theme = darkTheme ? 0 : 1;
  segmentField(ui, {"preferences.theme", words::preferences::theme}, kThemes, theme);
  darkTheme = theme == 0;
  static constexpr const char* kNames[] = {"75 %", "100 %", "125 %", "150 %", "200 %"};
  static_assert(std::size(kNames) == std::size(kInterfaceSizes));
  const auto nearest = std::min_element(std::begin(kInterfaceSizes), std::end(kInterfaceSizes), [&](float a, float b) {
    return std::abs(a - interfaceSize) < std::abs(b - interfaceSize);
  });
  int size = static_cast<int>(nearest - std::begin(kInterfaceSizes));
  if (segmentField(ui, {"preferences.size", words::preferences::size}, kNames, size))
    interfaceSize = kInterfaceSizes[size];
}

/// A bar as long as the editor believes 50 mm to be; what a ruler reads of it sets that right.
void rulerRow(Ui& ui, double pixels_per_mm, double& factor) {
  constexpr double kBar_mm = 50;
  heading(ui, words::menu::actualSize.label);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto length = static_cast<float>(kBar_mm * pixels_per_mm / factor);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 ink = packed(ui.theme.text);
  const float low = at.y + ui.px(10);
  draw.AddLine(ImVec2(at.x, low), ImVec2(at.x + length, low), ink, ui.px(1.5f));
  for (int i = 0; i <= 5; ++i) {
    const float x = at.x + length * static_cast<float>(i) / 5;
    draw.AddLine(ImVec2(x, at.y + ui.px(2)), ImVec2(x, low), ink, 1);
  }
  ImGui::Dummy(ImVec2(length, ui.px(14)));
  ui.probe.record("preferences.ruler_bar", at, ImVec2(at.x + length, low));
  NumberStyle style;
  style.unit = "mm";
  style.min = 10;
  style.max = 200;
  style.decimals = 1;
  double read_mm = kBar_mm;
  if (numberField(ui, {"preferences.ruler", words::preferences::ruler}, style, read_mm))
    factor = std::clamp(factor * read_mm / kBar_mm, kRulerFactor[0], kRulerFactor[1]);
}

void viewportRows(Ui& ui, const PreferencesDialog::Facts& facts, PreferenceValues values) {
  heading(ui, words::preferences::viewport);
  NumberStyle samples;
  samples.unit = words::preferences::samples;
  samples.unitOfOne = words::preferences::sample;
  samples.min = 1;
  samples.max = facts.mostSamples;
  samples.decimals = 0;
  samples.logarithmic = true;
  double wanted = values.samples;
  numberField(ui, {"preferences.samples", words::preferences::rest}, samples, wanted);
  values.samples = static_cast<int>(std::lround(wanted));
  NumberStyle memory;
  memory.unit = "GB";
  memory.min = 0.1;
  memory.max = std::max(memory.min, facts.machine_GB);
  memory.decimals = 1;
  numberField(ui, {"preferences.fibre_memory", words::preferences::lensMemory}, memory, values.fibreMemory_GB);
}

}  // namespace

bool PreferencesDialog::draw(Ui& ui, const Facts& facts, PreferenceValues values) {
  if (!open_ || !beginModal(ui, words::preferences::title, ImVec2(ui.px(560), 0), open_, opening_)) return false;
  beginModalRows(ui, "preferences.rows");
  lookRows(ui, values.darkTheme, values.interfaceSize);
  const bool chooses = displayColourRows(ui, facts.profiles, values.colours);
  rulerRow(ui, facts.pixels_per_mm, values.rulerFactor);
  heading(ui, words::preferences::units);
  countSystemRow(ui, "preferences", values.units.count);
  twistUnitRow(ui, "preferences", values.units.twistAsMultiplier);
  segmentField(ui, {"preferences.lengths", words::trade::lengthsIn}, words::trade::lengthUnits, values.draft.inches);
  heading(ui, words::preferences::usualPiece);
  pieceSizeRows(ui, "preferences", values.units.piece);
  viewportRows(ui, facts, values);
  endModalRows("preferences.rows");
  closeButtonBelow(ui, "preferences.close", open_);
  endModal();
  return chooses;
}

}  // namespace loomlight
