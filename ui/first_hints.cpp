#include "ui/first_hints.h"

#include "ui/widgets/fields.h"

namespace loomlight {
namespace {

void line(Ui& ui, const char* id, bool done, const char* what, const char* brings) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetFontSize(), radius = 0.36f * size;
  const ImVec2 centre(at.x + radius, at.y + 0.5f * size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (done)
    draw.AddCircleFilled(centre, radius, packed(ui.theme.accent));
  else
    draw.AddCircle(centre, radius, packed(ui.theme.textQuiet), 0, ui.px(1.5f));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + size + ui.px(6));
  ImGui::TextUnformatted(what);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ui.px(4));  // what belongs together stands together
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + size + ui.px(6));
  ImGui::TextDisabled("%s", brings);
  ui.probe.fact(id, done ? "done" : "open");
}

}  // namespace

void firstHints(Ui& ui, ImVec2 min, ImVec2 size, FirstHints& hints) {
  if (hints.drew && hints.turned && hints.set) hints.wanted = false;
  if (!hints.wanted) return;
  const float edge = ui.px(16);
  ImGui::SetNextWindowPos(ImVec2(min.x + size.x - edge, min.y + size.y - edge), ImGuiCond_Always, ImVec2(1, 1));
  ImGui::SetNextWindowSize(ImVec2(ui.px(336), 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(edge, edge));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.popup);
  ImGui::Begin("first hints", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PushFont(ui.fonts.strong);
  ImGui::TextUnformatted("Three things to try");
  ImGui::PopFont();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  line(ui, "hints.drew", hints.drew, "Click or drag in the draft", "The cloth is woven as you draw it.");
  line(ui, "hints.turned", hints.turned, "Drag the cloth to turn it", "The wheel goes in, down to fibres.");
  line(ui, "hints.set", hints.set, "Drag a number on the right", "Twist, count, fibre: the yarn follows.");
  const float width = ui.px(88);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("F1 lists all keys");
  ImGui::SameLine(ImGui::GetWindowWidth() - edge - width);
  if (button(ui, "hints.close", "Got it", width)) hints.wanted = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace loomlight
