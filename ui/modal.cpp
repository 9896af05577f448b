#include "ui/modal.h"

namespace loomlight {

bool beginModal(Ui& ui, const char* title, ImVec2 size, bool open) {
  if (open) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float edge = ui.px(24);
  size.x = std::min(size.x, screen.x - 2 * edge);
  if (size.y > 0) size.y = std::min(size.y, screen.y - 2 * edge);
  ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.5f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(size, ImGuiCond_Always);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(16), ui.px(10)));
  ImGui::PushFont(ui.fonts.strong);
  const bool shown = ImGui::BeginPopupModal(
      title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopFont();
  ImGui::PopStyleVar();
  return shown;
}

void endModal() {
  ImGui::EndPopup();
}

bool modalCancelled() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) && !ImGui::GetIO().WantTextInput;
}

}  // namespace loomlight
