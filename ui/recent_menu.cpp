#include "ui/recent_menu.h"

#include <filesystem>

#include "ui/widgets/fields.h"
#include "ui/words/menu_words.h"

namespace loomlight {

RecentMenuChoice recentMenu(Ui& ui, std::span<const RecentFile> files) {
  RecentMenuChoice choice;
  const bool open = ImGui::BeginMenu(words::menu::openRecent.label, !files.empty());
  if (!open) ui.probe.recordItem("menu.recent");
  if (!open) return choice;
  choice.appeared = ImGui::IsWindowAppearing();
  const float widest = ui.px(280);
  for (size_t i = 0; i < files.size(); ++i) {
    const std::filesystem::path path(files[i].file);
    const std::string name = shortened(path.filename().string(), widest);
    const std::string where =
        files[i].missing ? words::menu::missing.label : shortened(path.parent_path().filename().string() + "/", widest);
    ImGui::PushID(static_cast<int>(i));
    if (files[i].missing) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textQuiet);
    if (ImGui::MenuItem(name.c_str(), where.c_str())) choice.file = files[i].file;
    if (files[i].missing) ImGui::PopStyleColor();
    ImGui::PopID();
    const std::string id = "menu.recent/" + path.filename().string();
    ui.probe.recordItem(id);
    ui.probe.fact(id, files[i].missing ? words::menu::missing.label : "there");
    tooltipFor(ui, id.c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), files[i].file.c_str());
  }
  ImGui::Separator();
  choice.clear = ImGui::MenuItem(words::menu::forgetAll.label);
  ui.probe.recordItem("menu.recent_clear");
  ImGui::EndMenu();
  return choice;
}

}  // namespace loomlight
