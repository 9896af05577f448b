#include "ui/wif_dialog.h"

#include <fmt/core.h>

#include <cmath>

#include "ui/field_row.h"
#include "ui/modal.h"

namespace loomlight {
namespace {

std::string shown(const std::optional<double>& value, const char* unit, int decimals) {
  return value ? fmt::format("{:.{}f} {}", *value, decimals, unit) : std::string("\xE2\x80\x93");
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
  const auto row = [&](const char* what, std::optional<double> WifSett::*member, const char* unit, int decimals) {
    ImGui::TextDisabled("%s", what);
    size(0, shown(content.mine.*member, unit, decimals), chosen == WifSizeChoice::keep);
    size(1, shown(content.file.*member, unit, decimals), chosen == WifSizeChoice::file);
  };
  row("Ends", &WifSett::ends_per_cm, "/cm", 1);
  row("Picks", &WifSett::picks_per_cm, "/cm", 1);
  row("Warp yarn", &WifSett::warpDiameter_mm, "mm", 2);
  row("Weft yarn", &WifSett::weftDiameter_mm, "mm", 2);
}

bool says(const WifSett& sett) {
  return sett.ends_per_cm || sett.picks_per_cm || sett.warpDiameter_mm || sett.weftDiameter_mm;
}

}  // namespace

void WifDialog::show(Content content) {
  content_ = std::move(content);
  sizes_ = WifSizeChoice::keep;
  open_ = opening_ = true;
  closing_ = false;
}

std::optional<WifSizeChoice> WifDialog::draw(Ui& ui) {
  if (!open_ || !beginModal(ui, "Weaving file", ImVec2(ui.px(600), 0), open_, opening_)) return std::nullopt;
  std::optional<WifSizeChoice> changed;
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(content_.summary.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  if (says(content_.file)) {
    static constexpr const char* kNames[] = {"Keep mine", "Use the file's"};
    int chosen = static_cast<int>(sizes_);
    if (segmentField(
            ui,
            {"wif.sizes", "Sett and thickness",
             "Most programs write a default of their own here, whatever the cloth. Thick and thin threads keep "
             "their proportions either way."},
            kNames, chosen)) {
      sizes_ = static_cast<WifSizeChoice>(chosen);
      changed = sizes_;
    }
    sizeRows(ui, content_, sizes_);
  }
  if (!content_.warnings.empty()) {
    heading(ui, "Read otherwise than it is written");
    ImGui::BeginChild("wif.warnings", ImVec2(0, ui.px(150)));
    for (const std::string& warning : content_.warnings) {
      ImGui::Bullet();
      ImGui::SameLine();
      ImGui::TextWrapped("%s", warning.c_str());
    }
    ImGui::EndChild();
  }
  ui.probe.fact("wif.warnings", std::to_string(content_.warnings.size()));
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ui.px(136));
  if (button(ui, "wif.close", "Close", ui.px(120)) || modalCancelled() || closing_) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  endModal();
  return closing_ ? std::nullopt : changed;
}

}  // namespace loomlight
