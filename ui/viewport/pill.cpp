#include "ui/viewport/pill.h"

namespace loomlight {
namespace {

constexpr float kPad = 8;

}  // namespace

ImVec2 pillSize(Ui& ui, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float pad = ui.px(kPad);
  return ImVec2(size.x + 2 * pad, size.y + pad);
}

void pill(Ui& ui, ImVec2 corner, const std::string& text, const ImVec4& colour) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 size = pillSize(ui, text);
  const float pad = ui.px(kPad);
  draw.AddRectFilled(corner, ImVec2(corner.x + size.x, corner.y + size.y), IM_COL32(18, 18, 19, 205), ui.px(4));
  draw.AddText(ImVec2(corner.x + pad, corner.y + 0.5f * pad), packed(colour), text.c_str());
}

}  // namespace loomlight
