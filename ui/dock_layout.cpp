#include "ui/dock_layout.h"

#include <cmath>

namespace loomlight {
namespace {

constexpr float kGap = 4, kStatusHeight = 28, kNarrowest = 264;
constexpr float kShare = 0.246f, kWidestDraft = 560, kWidestInspector = 400;  // of panels that nobody has dragged

/// Panels take what they were given, unless the cloth would lose its half.
float fittedWidth(float wanted, float widestUndragged, float screenWidth) {
  if (wanted <= 0) wanted = std::min(kShare * screenWidth, widestUndragged);
  return std::clamp(wanted, kNarrowest, std::max(kNarrowest, 0.5f * 0.5f * screenWidth - kGap));
}

float draftWidth(const DockLayout& layout, float screenWidth) {
  return fittedWidth(layout.draftWidth, kWidestDraft, screenWidth);
}

float inspectorWidth(const DockLayout& layout, float screenWidth) {
  return fittedWidth(layout.inspectorWidth, kWidestInspector, screenWidth);
}

/// `width` of the panel beside it now; `kept` takes what a drag makes of it.
void splitter(Ui& ui, const char* name, ImVec2 min, ImVec2 size, float direction, float width, float& kept) {
  ImGui::SetNextWindowPos(min);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.window);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::InvisibleButton("drag", size);
  ui.probe.recordItem(name);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::GetWindowDrawList()->AddRectFilled(min, ImVec2(min.x + size.x, min.y + size.y), packed(ui.theme.fieldFill));
  }
  const float moved = ImGui::GetIO().MouseDelta.x;
  if (ImGui::IsItemActive() && moved != 0) kept = width + direction * moved / ui.scale;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace

DockAreas dockAreas(const DockLayout& layout, ImVec2 screen, float menuHeight, float scale, float stripHeight) {
  const float gap = std::floor(kGap * scale), status = std::round(kStatusHeight * scale);
  const float top = menuHeight + gap, height = std::max(1.0f, screen.y - top - gap - status);
  const float width1 = screen.x / scale;
  const float left = layout.panelsShown ? std::floor(draftWidth(layout, width1) * scale) : 0;
  const float right = layout.panelsShown ? std::floor(inspectorWidth(layout, width1) * scale) : 0;
  const float leftGap = left > 0 ? gap : 0, rightGap = right > 0 ? gap : 0;
  DockAreas areas;
  areas.draft = {ImVec2(0, top), ImVec2(left, height)};
  const float strip = stripHeight > 0 ? std::round(stripHeight * scale) : 0, stripGap = strip > 0 ? gap : 0;
  const float middle = screen.x - left - right - leftGap - rightGap;
  areas.viewport = {ImVec2(left + leftGap, top), ImVec2(middle, std::max(1.0f, height - strip - stripGap))};
  areas.strip = {ImVec2(left + leftGap, top + height - strip), ImVec2(middle, strip)};
  areas.inspector = {ImVec2(screen.x - right, top), ImVec2(right, height)};
  areas.status = {ImVec2(0, screen.y - status), ImVec2(screen.x, status)};
  return areas;
}

void splitters(Ui& ui, DockLayout& layout, const DockAreas& areas) {
  if (!layout.panelsShown) return;
  const float width1 = ImGui::GetIO().DisplaySize.x / ui.scale;
  const float gap = areas.viewport.min.x - areas.draft.size.x;
  const float height = areas.draft.size.y;
  splitter(ui, "splitter.left", ImVec2(areas.draft.size.x, areas.draft.min.y), ImVec2(gap, height), 1,
           draftWidth(layout, width1), layout.draftWidth);
  splitter(ui, "splitter.right", ImVec2(areas.inspector.min.x - gap, areas.draft.min.y), ImVec2(gap, height), -1,
           inspectorWidth(layout, width1), layout.inspectorWidth);
}

void beginPanel(const char* name, const DockAreas::Area& area, bool padded) {
  ImGui::SetNextWindowPos(area.min);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padded ? padding : ImVec2(padding.x, 0));
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (!padded) flags |= ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::Begin(name, nullptr, flags);
  ImGui::PopStyleVar(3);
}

void endPanel() {
  ImGui::End();
}

}  // namespace loomlight
