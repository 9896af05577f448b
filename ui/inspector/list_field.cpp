#include "ui/inspector/list_field.h"

#include <cmath>

#include "ui/widgets/fields.h"

namespace loomlight {

bool listField(Ui& ui, const RowText& text, std::string typed, const char* none, const std::string& expected,
               const std::function<bool(const std::string&)>& take) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 max(corner.x + ImGui::GetContentRegionAvail().x, corner.y + ImGui::GetFrameHeight());
  const ImGuiID id = ImGui::GetID(text.id.c_str());
  bool taken = false;
  if (textField(ui, text, typed, none)) {
    if (ui.memory.failed == id) ui.memory.failed = 0;
    taken = take(typed);
    if (!taken) refuseText(ui, id, expected);
  }
  showRefusal(ui, id, ImVec2(corner.x + std::floor(kLabelShare * (max.x - corner.x)), corner.y), max);
  return taken;
}

}  // namespace loomlight
