#include "ui/wif_dialog.h"

#include <fmt/core.h>

#include "ui/fields.h"
#include "ui/modal.h"

namespace loomlight {
namespace {

std::string shown(const std::optional<double>& value, const char* unit, int decimals) {
  return value ? fmt::format("{:.{}f} {}", *value, decimals, unit) : std::string("\xE2\x80\x93");
}

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

void sizeTable(Ui& ui, const WifSett& file, const WifSett& mine) {
  if (!ImGui::BeginTable("sizes", 3)) return;
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, ui.px(220));
  const auto row = [&](const char* what, std::optional<double> WifSett::*member, const char* unit, int decimals) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", what);
    cell(shown(mine.*member, unit, decimals));
    cell(shown(file.*member, unit, decimals));
  };
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  for (const char* head : {"Mine", "The file's"}) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", head);
  }
  row("Ends", &WifSett::ends_per_cm, "/cm", 1);
  row("Picks", &WifSett::picks_per_cm, "/cm", 1);
  row("Warp yarn", &WifSett::warpDiameter_mm, "mm", 2);
  row("Weft yarn", &WifSett::weftDiameter_mm, "mm", 2);
  ImGui::EndTable();
}

bool says(const WifSett& sett) {
  return sett.ends_per_cm || sett.picks_per_cm || sett.warpDiameter_mm || sett.weftDiameter_mm;
}

}  // namespace

void WifDialog::show(Content content) {
  content_ = std::move(content);
  sizes_ = WifSizeChoice::keep;
  open_ = opening_ = true;
}

std::optional<WifSizeChoice> WifDialog::draw(Ui& ui) {
  if (!open_ || !beginModal(ui, "Weaving file", ImVec2(ui.px(600), 0), open_, opening_)) return std::nullopt;
  std::optional<WifSizeChoice> changed;
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(content_.summary.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  if (says(content_.file)) {
    sizeTable(ui, content_.file, content_.mine);
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
  if (button(ui, "wif.close", "Close", ui.px(120)) || modalCancelled()) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  endModal();
  return changed;
}

}  // namespace loomlight
