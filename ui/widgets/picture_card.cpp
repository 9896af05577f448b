#include "ui/widgets/picture_card.h"

#include "ui/widgets/field_row.h"
#include "ui/widgets/fields.h"

namespace loomlight {

DrawnCard pictureCard(Ui& ui, const PictureCard& card) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetFrameHeight(), pad = ui.px(8);
  const ImVec2 corner(min.x + card.picture.x, min.y + card.picture.y), max(corner.x, corner.y + line);
  const bool isPressed = ImGui::InvisibleButton(card.id.c_str(), ImVec2(max.x - min.x, max.y - min.y));
  ui.probe.recordItem(card.id);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, packed(ui.theme.field), ui.px(4));
  if (card.texture)
    draw.AddImageRounded(card.texture, min, corner, ImVec2(0, 0), ImVec2(1, 1), IM_COL32_WHITE, ui.px(4),
                         ImDrawFlags_RoundCornersTop);
  else
    draw.AddRectFilled(min, corner, packed(ui.theme.surround), ui.px(4), ImDrawFlags_RoundCornersTop);
  std::string cut;
  const std::string name = fitted(ui, card.id, card.name, card.picture.x - 2 * pad - card.right, cut);
  draw.AddText(ImVec2(min.x + pad, corner.y + 0.5f * (line - ImGui::GetFontSize())),
               packed(card.isQuiet ? ui.theme.textQuiet : ui.theme.text), name.c_str());
  const bool isChosen = card.isChosen || isPressed;
  if (isChosen || ImGui::IsItemHovered())
    draw.AddRect(min, max, packed(isChosen ? ui.theme.accent : ui.theme.textQuiet), ui.px(4), 0, ui.px(2));
  tooltipFor(ui, card.id.c_str(), min, max, tooltipWith(cut, card.about.c_str()).c_str());
  return {corner, isPressed};
}

}  // namespace loomlight
