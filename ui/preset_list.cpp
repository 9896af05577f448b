#include "ui/preset_list.h"

#include "ui/fields.h"

namespace loomlight {

std::optional<std::string> presetList(Ui& ui, const std::vector<std::string>& names) {
  heading(ui, "Presets");
  std::optional<std::string> chosen;
  ImGui::BeginChild("presets", ImVec2(0, 0));
  if (names.empty())
    hint(ui,
         "File \xE2\x96\xB8 Keep as preset puts a cloth here. A preset dresses the scene: drape, light and camera "
         "stay.");
  for (const std::string& name : names) {
    if (ImGui::Selectable(name.c_str())) chosen = name;
    ui.probe.recordItem("preset/" + name);
  }
  ImGui::EndChild();
  return chosen;
}

}  // namespace loomlight
