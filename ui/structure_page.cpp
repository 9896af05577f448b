#include <algorithm>

#include "core/fabric/structure_edit.h"
#include "ui/draft_panel.h"
#include "ui/fields.h"
#include "ui/structure_thumbnail.h"

namespace loomlight {

std::optional<Fabric> structurePage(Ui& ui, const Fabric& fabric, const DraftPreferences& preferences,
                                    DraftView& view) {
  std::optional<Fabric> edited;
  const float size = ui.px(30), gap = ui.px(6), inset = ui.px(2);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
  ImGui::SetCursorPos(ImVec2(ImGui::GetCursorPosX() + inset, ImGui::GetCursorPosY() + inset));
  ImGui::BeginGroup();
  const int perLine = std::max(1, static_cast<int>((ImGui::GetContentRegionAvail().x + gap - inset) / (size + gap)));
  for (int i = 0; i < static_cast<int>(view.palette.size()); ++i) {
    if (i % perLine != 0) ImGui::SameLine(0, gap);
    const Structure& structure = view.palette[static_cast<size_t>(i)];
    if (structureThumbnail(ui, "structure/" + structure.name, structure, size, 10, structure.weave == fabric.weave)) {
      Rewoven result = withStructure(fabric, view.selection, structure.weave, preferences.loom);
      edited = std::move(result.fabric);
      view.remark = std::move(result.remark);
      if (!view.selection) view.cell = 0;
    }
  }
  ImGui::EndGroup();
  ImGui::PopStyleVar();
  ImGui::Dummy(ImVec2(0, ui.px(2)));
  view.libraryWanted = button(ui, "structures.open", "All structures\xE2\x80\xA6", 0, true,
                              "Every structure with its numbers, for the whole repeat or a selection.");
  return edited;
}

}  // namespace loomlight
