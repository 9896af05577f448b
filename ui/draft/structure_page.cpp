#include <algorithm>
#include <cmath>

#include "core/fabric/weave/structure_edit.h"
#include "ui/draft/draft_panel.h"
#include "ui/draft/structure_thumbnail.h"
#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

constexpr int kCells = 10;  // of a thumbnail, along each side

int thumbnailsPerLine(float size, float gap, float room) {
  return std::max(1, static_cast<int>((room + gap) / (size + gap)));
}

/// The largest with which all of them fit into the room; with cells of whole pixels.
float thumbnailSize(Ui& ui, int count, float gap, ImVec2 room) {
  const float step = kCells, smallest = step * std::round(ui.px(30) / step);
  float size = smallest;
  for (float larger = smallest + step; larger <= ui.px(80); larger += step) {
    const int perLine = thumbnailsPerLine(larger, gap, room.x), lines = (count + perLine - 1) / perLine;
    if (static_cast<float>(lines) * (larger + gap) <= room.y) size = larger;
  }
  return size;
}

}  // namespace

std::optional<Fabric> structurePage(Ui& ui, const Fabric& fabric, const DraftPreferences& preferences,
                                    DraftView& view) {
  std::optional<Fabric> edited;
  const float gap = ui.px(6), inset = ui.px(2), under = ImGui::GetFrameHeightWithSpacing() + ui.px(12);
  const int count = static_cast<int>(view.palette.size());
  const ImVec2 all = ImGui::GetContentRegionAvail(), room(all.x - inset, all.y - under);
  const float size = thumbnailSize(ui, count, gap, room);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
  ImGui::SetCursorPos(ImVec2(ImGui::GetCursorPosX() + inset, ImGui::GetCursorPosY() + inset));
  ImGui::BeginGroup();
  const int perLine = thumbnailsPerLine(size, gap, room.x);
  for (int i = 0; i < count; ++i) {
    if (i % perLine != 0) ImGui::SameLine(0, gap);
    const Structure& structure = view.palette[static_cast<size_t>(i)];
    if (structureThumbnail(ui, "structure/" + structure.name, structure, size, kCells,
                           structure.weave == fabric.weave)) {
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
