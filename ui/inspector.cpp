#include "ui/inspector.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/fields.h"

namespace loomlight {
namespace {

void pageTabs(Ui& ui, InspectorView& view) {
  static constexpr const char* kNames[] = {"Yarn", "Fibre", "Cloth", "Scene"};
  static constexpr const char* kIds[] = {"tab.yarn", "tab.fibre", "tab.cloth", "tab.scene"};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float all = ImGui::GetContentRegionAvail().x, width = all / 4, height = ImGui::GetFrameHeight() + ui.px(4);
  for (int i = 0; i < 4; ++i) {
    const ImVec2 a(corner.x + width * static_cast<float>(i), corner.y);
    ImGui::SetCursorScreenPos(a);
    if (ImGui::InvisibleButton(kIds[i], ImVec2(width, height))) view.page = static_cast<InspectorView::Page>(i);
    ui.probe.recordItem(kIds[i]);
    const bool open = static_cast<int>(view.page) == i;
    const bool lit = open || ImGui::IsItemHovered();
    ImGui::PushFont(open ? ui.fonts.strong : ui.fonts.regular);
    const ImVec2 size = ImGui::CalcTextSize(kNames[i]);
    draw.AddText(ImVec2(a.x + 0.5f * (width - size.x), a.y + 0.5f * (height - size.y)),
                 packed(lit ? ui.theme.text : ui.theme.textQuiet), kNames[i]);
    ImGui::PopFont();
    if (open)
      draw.AddRectFilled(ImVec2(a.x + ui.px(8), a.y + height - ui.px(2)), ImVec2(a.x + width - ui.px(8), a.y + height),
                         packed(ui.theme.text), ui.px(1));
  }
  draw.AddLine(ImVec2(corner.x, corner.y + height), ImVec2(corner.x + all, corner.y + height), packed(ui.theme.line));
  ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + height + ui.px(8)));
}

}  // namespace

void yarnChooser(Ui& ui, const Fabric& fabric, const std::vector<ImVec4>& colours, int& yarn, const char* prefix) {
  const float size = ui.px(28), all = ImGui::GetContentRegionAvail().x;
  const int perLine = std::max(1, static_cast<int>((all + ui.px(4)) / (size + ui.px(4))));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(4), ui.px(4)));
  for (int i = 0; i < static_cast<int>(fabric.yarns.size()); ++i) {
    if (i % perLine != 0) ImGui::SameLine();
    const std::string id = fmt::format("{}.yarn_{}", prefix, i);
    if (swatch(ui, id.c_str(), colours[static_cast<size_t>(i)], size, i == yarn,
               fabric.yarns[static_cast<size_t>(i)].name.c_str()))
      yarn = i;
  }
  ImGui::PopStyleVar();
}

int shownFibre(const Fabric& fabric, const InspectorView& view) {
  const Yarn& yarn = fabric.yarns[std::min(static_cast<size_t>(view.yarn), fabric.yarns.size() - 1)];
  return view.secondFibre && yarn.blendFibre ? *yarn.blendFibre : yarn.fibre;
}

InspectorResult inspector(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  view.yarn = std::clamp(view.yarn, 0, static_cast<int>(fabric.yarns.size()) - 1);
  pageTabs(ui, view);
  // The scroll bar lives in the panel's margin, always, so that rows are as wide on a page that needs none.
  const float margin = ImGui::GetStyle().ScrollbarSize;
  const ImVec4 grab = view.pageScrolls ? ui.theme.fieldFill : ImVec4(0, 0, 0, 0);
  ImGui::PushStyleColor(ImGuiCol_ScrollbarGrab, grab);
  static constexpr const char* kPages[] = {"yarn page", "fibre page", "cloth page", "scene page"};
  ImGui::BeginChild(kPages[static_cast<int>(view.page)], ImVec2(ImGui::GetContentRegionAvail().x + margin, 0), false,
                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysVerticalScrollbar);
  ImGui::PopStyleColor();
  view.pageScrolls = ImGui::GetScrollMaxY() > 0;
  view.visibilityShown = view.visibilityOpen && view.page == InspectorView::Page::yarn;
  InspectorResult result;
  switch (view.page) {
    case InspectorView::Page::yarn:
      result.fabric = yarnPage(ui, fabric, model, view);
      break;
    case InspectorView::Page::fibre:
      result.fabric = fibrePage(ui, fabric, model, view);
      break;
    case InspectorView::Page::cloth:
      result.fabric = clothPage(ui, fabric, model, view);
      break;
    case InspectorView::Page::scene:
      result = scenePage(ui, fabric);
      break;
  }
  ImGui::EndChild();
  return result;
}

}  // namespace loomlight
