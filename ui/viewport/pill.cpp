#include "ui/viewport/pill.h"

namespace loomlight {
namespace {

constexpr float kPad = 8;

/// What the text has of that room; 0 stays 0: lines are not broken.
float wrapWidth(Ui& ui, float room) {
  return room > 0 ? room - 2 * ui.px(kPad) : 0;
}

}  // namespace

ImVec2 pillSize(Ui& ui, const std::string& text, float room) {
  const float wrap = wrapWidth(ui, room);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap > 0 ? wrap : -1);
  const float pad = ui.px(kPad);
  return ImVec2(size.x + 2 * pad, size.y + pad);
}

void pill(Ui& ui, ImVec2 corner, const std::string& text, const ImVec4& colour, float room) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 size = pillSize(ui, text, room);
  const float pad = ui.px(kPad);
  draw.AddRectFilled(corner, ImVec2(corner.x + size.x, corner.y + size.y), IM_COL32(18, 18, 19, 205), ui.px(4));
  draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), ImVec2(corner.x + pad, corner.y + 0.5f * pad), packed(colour),
               text.c_str(), nullptr, wrapWidth(ui, room));
}

}  // namespace loomlight
