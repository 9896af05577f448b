#include "ui/widgets/panel_controls.h"

#include "ui/widgets/field_row.h"

namespace loomlight {

float toggleWidth(const Ui& ui, const char* name) {
  return ImGui::CalcTextSize(name).x + ui.px(16);
}

bool toggleButton(Ui& ui, const char* id, const char* name, const char* tooltip, bool& on) {
  const ImVec2 text = ImGui::CalcTextSize(name);
  const ImVec2 size(toggleWidth(ui, name), ImGui::GetFrameHeight()), min = ImGui::GetCursorScreenPos();
  tellIfClipped(ui, id, name, ImGui::GetContentRegionAvail().x - ui.px(8));
  const bool clicked = ImGui::InvisibleButton(id, size);
  const ImVec2 max(min.x + size.x, min.y + size.y);
  if (clicked) on = !on;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec4& back = on ? ui.theme.accent : ImGui::IsItemHovered() ? ui.theme.fieldHover : ui.theme.field;
  draw.AddRectFilled(min, max, packed(back), ImGui::GetStyle().FrameRounding);
  draw.AddText(ImVec2(min.x + ui.px(8), min.y + 0.5f * (size.y - text.y)),
               packed(on ? ui.theme.onAccent : ui.theme.textQuiet), name);
  ui.probe.record(id, min, max);
  tooltipFor(ui, id, min, max, tooltip);
  return clicked;
}

bool pageTabs(Ui& ui, std::span<const char* const> names, std::span<const char* const> ids, int& open) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float all = ImGui::GetContentRegionAvail().x, width = all / static_cast<float>(names.size());
  const float height = ImGui::GetFrameHeight() + ui.px(4);
  const auto leftOf = [&](size_t i) { return corner.x + width * static_cast<float>(i); };
  const int before = open;
  size_t hovered = names.size();
  for (size_t i = 0; i < ids.size(); ++i) {
    ImGui::SetCursorScreenPos(ImVec2(leftOf(i), corner.y));
    if (ImGui::InvisibleButton(ids[i], ImVec2(width, height))) open = static_cast<int>(i);
    if (ImGui::IsItemHovered()) hovered = i;
    ui.probe.recordItem(ids[i]);
  }
  // Drawn once all are asked, lest two look open for a frame.
  for (size_t i = 0; i < names.size(); ++i) {
    const bool isOpen = static_cast<int>(i) == open;
    const ImVec2 a(leftOf(i), corner.y);
    ImGui::PushFont(isOpen ? ui.fonts.strong : ui.fonts.regular);
    const ImVec2 size = ImGui::CalcTextSize(names[i]);
    draw.AddText(ImVec2(a.x + 0.5f * (width - size.x), a.y + 0.5f * (height - size.y)),
                 packed(isOpen || i == hovered ? ui.theme.text : ui.theme.textQuiet), names[i]);
    ImGui::PopFont();
    tellIfClipped(ui, ids[i], names[i], width);
    if (isOpen)
      draw.AddRectFilled(ImVec2(a.x + ui.px(8), a.y + height - ui.px(2)), ImVec2(a.x + width - ui.px(8), a.y + height),
                         packed(ui.theme.text), ui.px(1));
  }
  draw.AddLine(ImVec2(corner.x, corner.y + height), ImVec2(corner.x + all, corner.y + height), packed(ui.theme.line));
  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + height + ui.px(8)));
  return open != before;
}

void beginPage(Ui& ui, const char* id, float height, PageScroll& scroll) {
  // The bar is there always, so that rows are as wide on a page that needs none.
  const float width = ImGui::GetContentRegionAvail().x + ImGui::GetStyle().ScrollbarSize;
  ImGui::PushStyleColor(ImGuiCol_ScrollbarGrab, scroll.isNeeded ? ui.theme.fieldFill : ImVec4(0, 0, 0, 0));
  ImGui::BeginChild(id, ImVec2(width, height), false,
                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysVerticalScrollbar);
  ImGui::PopStyleColor();
  scroll.isNeeded = ImGui::GetScrollMaxY() > 0;
}

void endPage(PageScroll& scroll) {
  const float height = ImGui::GetWindowHeight(), bottom = ImGui::GetWindowPos().y + height;
  const ImVec2 end = ImGui::GetCursorScreenPos();
  if (end.y < bottom && height == scroll.height) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));  // which would be rounded, and the page creep
    ImGui::SetCursorScreenPos(ImVec2(end.x, bottom));
    ImGui::Dummy(ImVec2(0, 0));
    ImGui::PopStyleVar();
  }
  scroll.height = height;
  ImGui::EndChild();
}

}  // namespace loomlight
