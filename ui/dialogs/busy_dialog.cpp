#include "ui/dialogs/busy_dialog.h"

#include <fmt/core.h>

#include <cmath>

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"

namespace loomlight {
namespace {

constexpr double kUnseen_s = 0.3;

/// Fills as the work is done; goes to and fro where nobody knows how far it is.
void workBar(Ui& ui, const std::optional<double>& fraction, double seconds) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(4);
  const float part = fraction ? static_cast<float>(*fraction) * width : 0.25f * width;
  const float at = fraction ? 0 : (width - part) * static_cast<float>(0.5 - 0.5 * std::cos(2 * seconds));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, ImVec2(min.x + width, min.y + height), packed(ui.theme.field), ui.px(2));
  draw.AddRectFilled(ImVec2(min.x + at, min.y), ImVec2(min.x + at + part, min.y + height), packed(ui.theme.accent),
                     ui.px(2));
  ImGui::Dummy(ImVec2(width, height));
}

}  // namespace

bool BusyDialog::draw(Ui& ui, const std::optional<BusyWork>& work) {
  if (work && !open_) {
    open_ = opening_ = true;
    since_ = ui.time;
  }
  if (!open_) return false;
  if (work) work_ = *work;
  const double seconds = ui.time - since_;
  const bool seen = seconds >= kUnseen_s;
  ui.wakeWithin(seen ? 0.05 : kUnseen_s - seconds);
  if (!seen) ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg].w = 0;  // the theme brings it back with the next frame
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, seen ? ImGui::GetStyle().Alpha : 0.0f);
  bool cancelled = false;
  if (beginModal(ui, (std::string(words::common::oneMoment) + "##busy").c_str(), ImVec2(ui.px(480), 0), open_,
                 opening_)) {
    textLine(ui, "busy.text", work_.text, ui.theme.text, ui.px(440));
    ImGui::Dummy(ImVec2(0, ui.px(4)));
    workBar(ui, work_.fraction, seconds);
    ImGui::Dummy(ImVec2(0, ui.px(8)));
    const std::string done = work_.fraction ? fmt::format("{:.0f} %", 100 * *work_.fraction) : "";
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(ui.theme.textQuiet, "%s", done.c_str());
    ImGui::SameLine(ImGui::GetWindowWidth() - ui.px(136));
    if (work && work->canCancel)
      cancelled = button(ui, "busy.cancel", words::common::cancel, ui.px(120)) || modalCancelled(ui);
    else
      ImGui::Dummy(ImVec2(ui.px(120), ImGui::GetFrameHeight()));  // the dialog keeps its size
    if (seen) {
      ui.probe.fact("busy", work_.text);
      ui.probe.fact("busy.done", done);
    }
    if (!work) closeModal(open_);
    endModal();
  }
  ImGui::PopStyleVar();
  return cancelled && work.has_value();
}

}  // namespace loomlight
