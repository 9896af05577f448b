#include "ui/first_hints.h"

#include "ui/widgets/fields.h"
#include "ui/words/hint_words.h"

namespace loomlight {
namespace {

void line(Ui& ui, const char* id, bool done, const words::HintLine& said) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetFontSize(), radius = 0.36f * size;
  const ImVec2 centre(at.x + radius, at.y + 0.5f * size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (done)
    draw.AddCircleFilled(centre, radius, packed(ui.theme.accent));
  else
    draw.AddCircle(centre, radius, packed(ui.theme.textQuiet), 0, ui.px(1.5f));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + size + ui.px(6));
  ImGui::TextUnformatted(said.what);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ui.px(4));  // what belongs together stands together
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + size + ui.px(6));
  ImGui::TextDisabled("%s", said.brings);
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
  ImGui::Begin("first_hints", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PushFont(ui.fonts.strong);
  ImGui::TextUnformatted(words::hints::title);
  ImGui::PopFont();
  ImGui::Dummy(ImVec2(0, ui.px(4)));
  line(ui, "hints.drew", hints.drew, words::hints::draw);
  line(ui, "hints.turned", hints.turned, words::hints::turn);
  line(ui, "hints.set", hints.set, words::hints::set);
  const float width = ui.px(88);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", words::hints::allKeys);
  ImGui::SameLine(ImGui::GetWindowWidth() - edge - width);
  if (button(ui, "hints.close", words::hints::close, width)) hints.wanted = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace loomlight
