#include "ui/viewport/denoise_button.h"

#include <cmath>

#include "ui/widgets/fields.h"
#include "ui/words/viewport_words.h"

namespace loomlight {

void denoiseButton(Ui& ui, bool& on, float width) {
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + width, min.y + ImGui::GetFrameHeight());
  if (ImGui::InvisibleButton("view.denoise", {width, max.y - min.y})) on = !on;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec4& ground = on ? ui.theme.accent : ImGui::IsItemHovered() ? ui.theme.fieldFill : ui.theme.fieldHover;
  draw.AddRectFilled(min, max, packed(ground), ImGui::GetStyle().FrameRounding);
  // A disc, grainy on one side and even on the other.
  const ImU32 ink = packed(on ? ui.theme.onAccent : ui.theme.text);
  const ImVec2 centre(std::floor(0.5f * (min.x + max.x)), std::floor(0.5f * (min.y + max.y)));
  const float half = 1.5707963f;
  draw.PathArcTo(centre, ui.px(7), -half, half);
  draw.PathFillConvex(ink);
  const ImVec2 kGrains[] = {{-2, -5.5f}, {-5, -3}, {-2, -1.5f}, {-6, 0.5f}, {-3, 2}, {-5, 4}, {-1.5f, 5.5f}};
  for (const ImVec2& grain : kGrains)
    draw.AddCircleFilled({centre.x + ui.px(grain.x), centre.y + ui.px(grain.y)}, ui.px(1), ink);
  ui.probe.record("view.denoise", min, max);
  tooltipFor(ui, "view.denoise", min, max, words::viewport::denoiseHelp);
}

}  // namespace loomlight
