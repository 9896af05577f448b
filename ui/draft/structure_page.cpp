#include <algorithm>
#include <cmath>

#include "core/fabric/weave/structure_edit.h"
#include "ui/draft/draft_panel.h"
#include "ui/draft/structure_thumbnail.h"
#include "ui/widgets/fields.h"
#include "ui/words/draft_words.h"

namespace loomlight {
namespace {

constexpr int kCells = 10;  // of a thumbnail, along each side

/// A thumbnail with its name below, which has this much room.
struct ThumbnailSlot {
  float size = 0, width = 0, height = 0;
};

ThumbnailSlot slotOf(Ui& ui, float size) {
  return {size, std::max(size, ui.px(66)), size + ui.px(2) + ui.fonts.small->FontSize};
}

int thumbnailsPerLine(const ThumbnailSlot& slot, float gap, float room) {
  return std::max(1, static_cast<int>((room + gap) / (slot.width + gap)));
}

/// A name that has not the room is read in a tooltip.
void nameBelow(Ui& ui, const std::string& name, ImVec2 at, const ThumbnailSlot& slot) {
  ImGui::PushFont(ui.fonts.small);
  const std::string shown = shortened(name, slot.width);
  ImGui::SetCursorPos(
      ImVec2(at.x + 0.5f * (slot.width - ImGui::CalcTextSize(shown.c_str()).x), at.y + slot.size + ui.px(2)));
  ImGui::TextColored(ui.theme.textQuiet, "%s", shown.c_str());
  ImGui::PopFont();
  const std::string id = "structure/" + name + "/name";
  ui.probe.recordItem(id);
  if (shown != name) tooltipFor(ui, id.c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), name.c_str());
}

/// The largest with which all of them fit into the room; with cells of whole pixels.
float thumbnailSize(Ui& ui, int count, float gap, ImVec2 room) {
  const float step = kCells, smallest = step * std::round(ui.px(30) / step);
  float size = smallest;
  for (float larger = smallest + step; larger <= ui.px(80); larger += step) {
    const ThumbnailSlot slot = slotOf(ui, larger);
    const int perLine = thumbnailsPerLine(slot, gap, room.x), lines = (count + perLine - 1) / perLine;
    if (static_cast<float>(lines) * (slot.height + gap) <= room.y) size = larger;
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
  const ThumbnailSlot slot = slotOf(ui, size);
  const int perLine = thumbnailsPerLine(slot, gap, room.x);
  const ImVec2 corner(ImGui::GetCursorPosX() + inset, ImGui::GetCursorPosY() + inset);
  for (int i = 0; i < count; ++i) {
    const Structure& structure = view.palette[static_cast<size_t>(i)];
    const ImVec2 at(corner.x + static_cast<float>(i % perLine) * (slot.width + gap),
                    corner.y + static_cast<float>(i / perLine) * (slot.height + gap));
    nameBelow(ui, structure.name, at, slot);
    ImGui::SetCursorPos(ImVec2(at.x + 0.5f * (slot.width - size), at.y));
    if (structureThumbnail(ui, "structure/" + structure.name, structure, size, kCells,
                           structure.weave == fabric.weave)) {
      Rewoven result = withStructure(fabric, view.selection, structure.weave, preferences.loom);
      edited = std::move(result.fabric);
      view.remark = std::move(result.remark);
      if (!view.selection) view.cell = 0;
    }
  }
  const int lines = (count + perLine - 1) / perLine;
  ImGui::SetCursorPos(ImVec2(corner.x - inset, corner.y + static_cast<float>(lines) * (slot.height + gap)));
  ImGui::Dummy(ImVec2(0, ui.px(2)));
  const Word& library = words::draft::allStructures;
  view.libraryWanted = button(ui, "structures.open", library.label, 0, true, library.help);
  return edited;
}

}  // namespace loomlight
