#include "ui/compare_dialog.h"

#include <algorithm>

#include "ui/fields.h"
#include "ui/modal.h"

namespace loomlight {
namespace {

/// The largest rectangle of these proportions in the middle of a room.
void fit(float aspect, ImVec2& min, ImVec2& max) {
  const float width = std::min(max.x - min.x, aspect * (max.y - min.y)), height = width / aspect;
  const ImVec2 centre(0.5f * (min.x + max.x), 0.5f * (min.y + max.y));
  min = ImVec2(centre.x - 0.5f * width, centre.y - 0.5f * height);
  max = ImVec2(centre.x + 0.5f * width, centre.y + 0.5f * height);
}

void drawPicture(ImTextureID picture, ImVec2 min, ImVec2 max) {
  if (picture) ImGui::GetWindowDrawList()->AddImage(picture, min, max);
}

}  // namespace

/// The first on the left of a line that follows the mouse, the second on its right.
void CompareDialog::drawSlider(Ui& ui, const Model& model, ImVec2 min, ImVec2 max) {
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("slider", ImVec2(max.x - min.x, max.y - min.y));
  ui.probe.recordItem("compare.slider");
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive()) divide_ = std::clamp((ImGui::GetIO().MousePos.x - min.x) / (max.x - min.x), 0.0f, 1.0f);
  const float x = min.x + divide_ * (max.x - min.x);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (model.first) draw.AddImage(model.first, min, ImVec2(x, max.y), ImVec2(0, 0), ImVec2(divide_, 1));
  if (model.second) draw.AddImage(model.second, ImVec2(x, min.y), max, ImVec2(divide_, 0), ImVec2(1, 1));
  draw.AddLine(ImVec2(x, min.y), ImVec2(x, max.y), packed(ui.theme.accent), ui.px(2));
}

void CompareDialog::draw(Ui& ui, const Model& model) {
  if (!open_) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  if (!beginModal(ui, "Compare", ImVec2(0.9f * screen.x, 0.9f * screen.y), open_, opening_)) return;
  static constexpr const char* kWays[] = {"Slider", "Side by side", "Difference"};
  int way = static_cast<int>(way_);
  segmentField(ui,
               {"compare.way", "See them by",
                "Slider: drag the line. Difference: black where they are alike, four times as bright as they are "
                "apart."},
               kWays, way);
  way_ = static_cast<Way>(way);
  const std::string names = model.firstName + "   |   " + model.secondName;
  hint(ui, names);
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  ImVec2 min = corner, max(corner.x + room.x, corner.y + room.y - ImGui::GetFrameHeight() - ui.px(12));
  const float bottom = max.y;
  if (way_ == Way::sideBySide) {
    const float middle = 0.5f * (min.x + max.x), gap = ui.px(4);
    ImVec2 leftMax(middle - gap, max.y), rightMin(middle + gap, min.y);
    fit(model.aspect, min, leftMax);
    fit(model.aspect, rightMin, max);
    drawPicture(model.first, min, leftMax);
    drawPicture(model.second, rightMin, max);
  } else {
    fit(model.aspect, min, max);
    if (way_ == Way::slider)
      drawSlider(ui, model, min, max);
    else
      drawPicture(model.difference, min, max);
  }
  ui.probe.record("compare.picture", min, max);
  const float width = ui.px(120);
  ImGui::SetCursorScreenPos(ImVec2(corner.x + room.x - width, bottom + ui.px(12)));
  if (button(ui, "compare.close", "Close", width) || modalCancelled()) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  endModal();
}

}  // namespace loomlight
