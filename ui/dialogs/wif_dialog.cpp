#include "ui/dialogs/wif_dialog.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/field_row.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"
#include "ui/words/dialog_words.h"
#include "ui/words/panel_words.h"

namespace loomlight {
namespace {

std::string shown(const std::optional<double>& value, const char* unit, int decimals) {
  return value ? fmt::format("{:.{}f} {}", *value, decimals, unit) : std::string(words::panels::none);
}

/// The sizes between which is chosen, each below its name in the row above.
void sizeRows(Ui& ui, const WifDialog::Content& content, WifSizeChoice chosen) {
  const float all = ImGui::GetContentRegionAvail().x, labels = std::floor(kLabelShare * all);
  const float left = ImGui::GetCursorPosX() + labels, half = 0.5f * (all - labels);
  const auto size = [&](int column, const std::string& text, bool counts) {
    const float inset = 0.5f * (half - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::SameLine(left + static_cast<float>(column) * half + inset);
    ImGui::TextColored(counts ? ui.theme.text : ui.theme.textQuiet, "%s", text.c_str());
  };
  const auto row = [&](const char* what, std::optional<double> WifSett::* member, const char* unit, int decimals) {
    ImGui::TextDisabled("%s", what);
    size(0, shown(content.mine.*member, unit, decimals), chosen == WifSizeChoice::keep);
    size(1, shown(content.file.*member, unit, decimals), chosen == WifSizeChoice::file);
  };
  row(words::ends.label, &WifSett::ends_per_cm, "/cm", 1);
  row(words::picks.label, &WifSett::picks_per_cm, "/cm", 1);
  row(words::wif::warpYarn, &WifSett::warpDiameter_mm, "mm", 2);
  row(words::wif::weftYarn, &WifSett::weftDiameter_mm, "mm", 2);
}

/// Each with its place in the file below it.
void warningRows(Ui& ui, const std::vector<WifWarning>& warnings) {
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  heading(ui, warnings.size() == 1 ? words::wif::oneWarning : words::wif::warnings);
  const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
  const float inner = ImGui::GetContentRegionAvail().x - ui.px(24);
  float height = ui.px(16);
  for (const WifWarning& warning : warnings)
    height += ImGui::CalcTextSize(warning.sentence.c_str(), nullptr, false, inner).y +
              (warning.place.empty() ? 1.0f : 2.5f) * ImGui::GetTextLineHeightWithSpacing();
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.theme.field);
  ImGui::BeginChild("wif.warnings", ImVec2(0, std::min({height, ui.px(200), roomAboveButtons(ui)})), false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(spacing.x, ui.px(2)));
  for (const WifWarning& warning : warnings) {
    ImGui::TextWrapped("%s", warning.sentence.c_str());
    if (!warning.place.empty()) hint(ui, warning.place);
    ImGui::Dummy(ImVec2(0, ui.px(6)));
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

/// Whether what the file only counts stays; true where that changes.
bool threadsField(Ui& ui, const std::string& cut, WifThreadChoice& threads) {
  const bool changed = segmentField(ui, {"wif.threads", words::wif::threads}, words::wif::threadChoices, threads);
  hint(ui, cut);
  return changed;
}

bool says(const WifSett& sett) {
  return sett.ends_per_cm || sett.picks_per_cm || sett.warpDiameter_mm || sett.weftDiameter_mm;
}

}  // namespace

void WifDialog::show(Content content) {
  content_ = std::move(content);
  choices_ = {says(content_.file) ? WifSizeChoice::file : WifSizeChoice::keep, WifThreadChoice::all};
  open_ = opening_ = true;
  closing_ = false;
}

std::optional<WifChoices> WifDialog::draw(Ui& ui) {
  if (!open_ || !beginModal(ui, words::wifDraft.label, ImVec2(ui.px(600), 0), open_, opening_)) return std::nullopt;
  bool changed = false;
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(content_.summary.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  if (says(content_.file)) {
    changed = segmentField(ui, {"wif.sizes", words::wif::sizes}, words::wif::sizeChoices, choices_.sizes);
    sizeRows(ui, content_, choices_.sizes);
    // Laid out even when it does not count, so that the dialog keeps its size.
    ImVec4 ink = ui.theme.warning;
    if (choices_.sizes == WifSizeChoice::keep) ink.w = 0;
    for (const WifWarning& warning : content_.beyond) hint(ui, warning.sentence, ink);
  } else {
    hint(ui, words::wif::saysNoSizes);
  }
  if (!content_.cut.empty()) changed = threadsField(ui, content_.cut, choices_.threads) || changed;
  if (!content_.warnings.empty()) warningRows(ui, content_.warnings);
  ui.probe.fact("wif.warnings", std::to_string(content_.warnings.size()));
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ui.px(136));
  if (mainButton(ui, "wif.close", words::common::close, ui.px(120)) || modalCancelled(ui) || modalConfirmed(ui) ||
      closing_)
    closeModal(open_);
  endModal();
  return changed && !closing_ ? std::optional(choices_) : std::nullopt;
}

}  // namespace loomlight
