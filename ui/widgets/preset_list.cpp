#include "ui/widgets/preset_list.h"

#include "ui/widgets/fields.h"

namespace loomlight {

std::optional<PresetChoice> presetList(Ui& ui, const std::vector<std::string>& own,
                                       const std::vector<std::string>& samples, bool& browse) {
  if (ImGui::GetContentRegionAvail().y < ui.px(kLowestPresetList) - 1) {
    browse = button(ui, "presets.browse", "Presets\xE2\x80\xA6", 0, true, "Cloths to start from, by pictures (Ctrl+B)");
    return std::nullopt;
  }
  heading(ui, "Presets");
  std::optional<PresetChoice> chosen;
  ImGui::BeginChild("presets", ImVec2(0, 0));
  auto list = [&](const std::vector<std::string>& names, bool isSample) {
    for (size_t i = 0; i < names.size(); ++i) {
      ImGui::PushID(isSample ? static_cast<int>(i) : -1 - static_cast<int>(i));
      if (ImGui::Selectable(names[i].c_str())) chosen = {isSample, i};
      const std::string id = (isSample ? "sample/" : "preset/") + names[i];
      ui.probe.recordItem(id);
      tooltipFor(ui, id.c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                 "Puts this cloth on the present drape, in the present light.");
      ImGui::PopID();
    }
  };
  list(own, false);
  if (!own.empty()) ImGui::Separator();
  list(samples, true);
  ImGui::EndChild();
  return chosen;
}

}  // namespace loomlight
