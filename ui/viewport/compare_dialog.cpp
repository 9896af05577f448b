#include "ui/viewport/compare_dialog.h"

#include <algorithm>

#include "ui/widgets/field_row.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"
#include "ui/words/viewport_words.h"

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

/// Each above its picture, or at its side of the one in which they meet.
void CompareDialog::drawNames(Ui& ui, const Model& model, float left, float middle, float right) const {
  const float gap = ui.px(16), top = ImGui::GetCursorScreenPos().y;
  ImGui::PushFont(ui.fonts.small);
  std::string firstCut, secondCut;
  const std::string first = fitted(ui, "compare.first", model.firstName.c_str(), middle - left - gap, firstCut);
  const std::string second = fitted(ui, "compare.second", model.secondName.c_str(), right - middle - gap, secondCut);
  const float at = way_ == Way::sideBySide ? middle : right - ImGui::CalcTextSize(second.c_str()).x;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddText(ImVec2(left, top), packed(ui.theme.textQuiet), first.c_str());
  draw.AddText(ImVec2(at, top), packed(ui.theme.textQuiet), second.c_str());
  const float bottom = top + ImGui::GetFontSize();
  ImGui::PopFont();
  tooltipFor(ui, "compare.first", ImVec2(left, top), ImVec2(middle - gap, bottom), firstCut.c_str());
  tooltipFor(ui, "compare.second", ImVec2(at, top), ImVec2(right, bottom), secondCut.c_str());
}

/// The first on the left of a line that follows the mouse, the second on its right: both of the height of the first, so
/// that what is seen from one place is of one size though the views are not of one width.
void CompareDialog::drawSlider(Ui& ui, const Model& model, ImVec2 min, ImVec2 max) {
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("slider", ImVec2(max.x - min.x, max.y - min.y));
  ui.probe.recordItem("compare.slider");
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive()) divide_ = std::clamp((ImGui::GetIO().MousePos.x - min.x) / (max.x - min.x), 0.0f, 1.0f);
  const float x = min.x + divide_ * (max.x - min.x);
  const float middle = 0.5f * (min.x + max.x), reach = 0.5f * model.secondAspect * (max.y - min.y);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (model.first) draw.AddImage(model.first, min, ImVec2(x, max.y), ImVec2(0, 0), ImVec2(divide_, 1));
  draw.PushClipRect(ImVec2(x, min.y), max, true);
  draw.AddRectFilled(min, max, packed(ui.theme.surround));  // what a narrower one leaves
  drawPicture(model.second, ImVec2(middle - reach, min.y), ImVec2(middle + reach, max.y));
  draw.PopClipRect();
  draw.AddLine(ImVec2(x, min.y), ImVec2(x, max.y), packed(ui.theme.accent), ui.px(2));
}

void CompareDialog::draw(Ui& ui, const Model& model) {
  if (!open_) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  if (!beginModal(ui, words::views::compare.label, ImVec2(0.9f * screen.x, 0.9f * screen.y), open_, opening_)) return;
  ImGui::BeginChild("way", ImVec2(ui.px(460), ImGui::GetFrameHeight()));
  segmentField(ui, {"compare.way", words::views::way, true}, words::views::ways, way_);
  ImGui::EndChild();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  ImVec2 min(corner.x, corner.y + ImGui::GetTextLineHeightWithSpacing());
  ImVec2 max(corner.x + room.x, corner.y + room.y - ImGui::GetFrameHeight() - ui.px(12));
  const float bottom = max.y;
  if (way_ == Way::sideBySide) {
    const float middle = 0.5f * (min.x + max.x), gap = ui.px(4);
    ImVec2 leftMax(middle - gap, max.y), rightMin(middle + gap, min.y);
    fit(model.firstAspect, min, leftMax);
    fit(model.secondAspect, rightMin, max);
    drawNames(ui, model, min.x, rightMin.x, max.x);
    drawPicture(model.first, min, leftMax);
    drawPicture(model.second, rightMin, max);
  } else {
    fit(model.firstAspect, min, max);
    drawNames(ui, model, min.x, 0.5f * (min.x + max.x), max.x);
    if (way_ == Way::slider)
      drawSlider(ui, model, min, max);
    else
      drawPicture(model.difference, min, max);
  }
  ui.probe.record("compare.picture", min, max);
  const float width = ui.px(120);
  ImGui::SetCursorScreenPos(ImVec2(corner.x + room.x - width, bottom + ui.px(12)));
  if (button(ui, "compare.close", words::common::close, width) || modalCancelled(ui)) closeModal(open_);
  endModal();
}

}  // namespace loomlight
