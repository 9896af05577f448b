#include "ui/dialogs/busy_dialog.h"

#include <cmath>

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"

namespace loomlight {
namespace {

constexpr double kUnseen_s = 0.3;

/// Goes to and fro, as nobody knows how far the work is.
void movingBar(Ui& ui, double seconds) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(4), part = 0.25f * width;
  const float at = (width - part) * static_cast<float>(0.5 - 0.5 * std::cos(2 * seconds));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, ImVec2(min.x + width, min.y + height), packed(ui.theme.field), ui.px(2));
  draw.AddRectFilled(ImVec2(min.x + at, min.y), ImVec2(min.x + at + part, min.y + height), packed(ui.theme.accent),
                     ui.px(2));
  ImGui::Dummy(ImVec2(width, height));
}

}  // namespace

bool BusyDialog::draw(Ui& ui, const std::optional<std::string>& text, bool canCancel) {
  if (text && !open_) {
    open_ = opening_ = true;
    since_ = ui.time;
  }
  if (!open_) return false;
  if (text) text_ = *text;
  const double seconds = ui.time - since_;
  const bool seen = seconds >= kUnseen_s;
  ui.wakeWithin(seen ? 0.05 : kUnseen_s - seconds);
  if (!seen) ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg].w = 0;  // the theme brings it back with the next frame
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, seen ? ImGui::GetStyle().Alpha : 0.0f);
  bool cancelled = false;
  if (beginModal(ui, (std::string(words::common::oneMoment) + "##busy").c_str(), ImVec2(ui.px(480), 0), open_,
                 opening_)) {
    textLine(ui, "busy.text", text_, ui.theme.text, ui.px(440));
    ImGui::Dummy(ImVec2(0, ui.px(4)));
    movingBar(ui, seconds);
    ImGui::Dummy(ImVec2(0, ui.px(8)));
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ui.px(136));
    if (canCancel)
      cancelled = button(ui, "busy.cancel", words::common::cancel, ui.px(120)) || modalCancelled(ui);
    else
      ImGui::Dummy(ImVec2(ui.px(120), ImGui::GetFrameHeight()));  // the dialog keeps its size
    if (seen) ui.probe.fact("busy", text_);
    if (!text) {
      open_ = false;
      ImGui::CloseCurrentPopup();
    }
    endModal();
  }
  ImGui::PopStyleVar();
  return cancelled && text.has_value();
}

}  // namespace loomlight
