#include "ui/draft/structure_thumbnail.h"

#include "ui/widgets/fields.h"

namespace loomlight {

void drawThumbnail(Ui& ui, const Weave& weave, ImVec2 min, float size, int cells) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float cell = size / static_cast<float>(cells);
  draw.AddRectFilled(min, ImVec2(min.x + size, min.y + size), packed(ui.theme.paper), ui.px(2));
  for (int pick = 0; pick < cells; ++pick)
    for (int end = 0; end < cells; ++end) {
      if (!weave.warpOver(pick, end)) continue;
      const float x = min.x + cell * static_cast<float>(end), y = min.y + size - cell * static_cast<float>(pick + 1);
      draw.AddRectFilled(ImVec2(x, y), ImVec2(x + cell, y + cell), packed(ui.theme.ink));
    }
}

bool structureThumbnail(Ui& ui, const std::string& id, const Structure& structure, float size, int cells, bool chosen) {
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size, min.y + size);
  const bool clicked = ImGui::InvisibleButton(id.c_str(), ImVec2(size, size));
  ui.probe.recordItem(id);
  drawThumbnail(ui, structure.weave, min, size, cells);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRect(min, max, packed(ui.theme.line), ui.px(2));
  if (chosen || ImGui::IsItemHovered())
    draw.AddRect(ImVec2(min.x - ui.px(2), min.y - ui.px(2)), ImVec2(max.x + ui.px(2), max.y + ui.px(2)),
                 packed(chosen ? ui.theme.accent : ui.theme.textQuiet), ui.px(4), 0, ui.px(1.5f));
  tooltipFor(ui, id.c_str(), min, max, structure.name.c_str());
  return clicked;
}

}  // namespace loomlight
