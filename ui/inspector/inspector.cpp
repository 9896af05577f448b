#include "ui/inspector/inspector.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/fabric/yarn/yarn_name.h"
#include "ui/widgets/fields.h"
#include "ui/words/panel_words.h"

namespace loomlight {

void yarnChooser(Ui& ui, const ShownYarns& yarns, int& yarn, const char* prefix) {
  const float size = ui.px(28), all = ImGui::GetContentRegionAvail().x;
  const int perLine = std::max(1, static_cast<int>((all + ui.px(4)) / (size + ui.px(4))));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(4), ui.px(4)));
  for (int i = 0; i < static_cast<int>(yarns.colours.size()); ++i) {
    if (i % perLine != 0) ImGui::SameLine();
    const std::string id = fmt::format("{}.yarn_{}", prefix, i);
    const std::string name = yarnLetters(i) + "   " + yarns.names[static_cast<size_t>(i)];
    if (swatch(ui, id.c_str(), yarns.colours[static_cast<size_t>(i)], size, i == yarn, name.c_str())) yarn = i;
  }
  ImGui::PopStyleVar();
}

void quietLine(Ui& ui, const char* id, const std::string& text) {
  ImGui::PushFont(ui.fonts.small);
  const std::string shown = shortened(text, ImGui::GetContentRegionAvail().x);
  ImGui::TextColored(ui.theme.textQuiet, "%s", shown.c_str());
  ImGui::PopFont();
  ui.probe.recordItem(id);
  if (shown != text) tooltipFor(ui, id, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), text.c_str());
}

int shownFibre(const Fabric& fabric, const InspectorView& view) {
  const Yarn& yarn = fabric.yarns[std::min(static_cast<size_t>(view.yarn), fabric.yarns.size() - 1)];
  return view.secondFibre && yarn.blendFibre ? *yarn.blendFibre : yarn.fibre;
}

InspectorResult inspector(Ui& ui, const Fabric& fabric, const InspectorModel& model, InspectorView& view) {
  view.yarn = std::clamp(view.yarn, 0, static_cast<int>(fabric.yarns.size()) - 1);
  static constexpr const char* kIds[] = {"tab.yarn", "tab.fibre", "tab.cloth", "tab.scene"};
  int open = static_cast<int>(view.page);
  pageTabs(ui, words::panels::inspectorTabs, kIds, open);
  view.page = static_cast<InspectorView::Page>(open);
  static constexpr const char* kPages[] = {"yarn_page", "fibre_page", "cloth_page", "scene_page"};
  beginPage(ui, kPages[open], 0, view.scroll);
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
      result = scenePage(ui, fabric, model);
      break;
  }
  endPage(view.scroll);
  return result;
}

}  // namespace loomlight
