#include "ui/widgets/preset_list.h"

#include "ui/widgets/fields.h"
#include "ui/words/menu_words.h"
#include "ui/words/preset_words.h"

namespace loomlight {

std::optional<PresetChoice> presetList(Ui& ui, const std::vector<std::string>& own,
                                       const std::vector<std::string>& samples, PageScroll& scroll, bool& browse) {
  if (ImGui::GetContentRegionAvail().y < ui.px(kLowestPresetList) - 1) {
    browse = button(ui, "presets.browse", words::menu::presets.label, 0, true, words::presets::browseHelp);
    return std::nullopt;
  }
  heading(ui, words::presets::title);
  std::optional<PresetChoice> chosen;
  beginPage(ui, "presets", 0, scroll);
  auto list = [&](const std::vector<std::string>& names, bool isSample) {
    for (size_t i = 0; i < names.size(); ++i) {
      ImGui::PushID(isSample ? static_cast<int>(i) : -1 - static_cast<int>(i));
      const std::string id = (isSample ? "sample/" : "preset/") + names[i];
      if (listLine(ui, id, names[i].c_str(), false, words::presets::choiceHelp)) chosen = {isSample, i};
      ImGui::PopID();
    }
  };
  list(own, false);
  if (!own.empty()) ImGui::Separator();
  list(samples, true);
  endPage(scroll);
  return chosen;
}

}  // namespace loomlight
