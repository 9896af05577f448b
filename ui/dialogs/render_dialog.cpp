#include "ui/dialogs/render_dialog.h"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "ui/widgets/field_row.h"
#include "ui/widgets/modal.h"
#include "ui/words/common_words.h"
#include "ui/words/file_words.h"
#include "ui/words/picture_words.h"

namespace loomlight {
namespace {

constexpr float kProgressHeight = 4;

/// Below the row of the file, with its name: the path may go on beyond its field.
bool chooseFileButton(Ui& ui, const std::string& dialog, const std::string& file) {
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(std::floor(ImGui::GetContentRegionAvail().x * kLabelShare) + ui.px(16));
  const bool pressed = button(ui, (dialog + ".browse").c_str(), words::files::choose);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const std::string name = std::filesystem::path(file).filename().string();
  textLine(ui, (dialog + ".name").c_str(), name, ui.theme.textQuiet);
  return pressed;
}

/// Pixels between the rows that scroll and the buttons: the file's row and its button, progress and outcome.
float heightBelowRows(const Ui& ui) {
  const float progress = ui.px(kProgressHeight) + ImGui::GetStyle().ItemSpacing.y;
  return 2 * ImGui::GetFrameHeightWithSpacing() + progress + ImGui::GetTextLineHeightWithSpacing();
}

struct ButtonsAnswer {
  bool start = false, cancel = false, close = false;
};

/// The last rows of the dialog: progress or outcome; Cancel or Close, and Render where a file is named, or Replace
/// where there is one already.
ButtonsAnswer progressAndButtons(Ui& ui, const std::string& dialog, const RenderJob& job, const std::string& file) {
  ImGui::ProgressBar(static_cast<float>(job.fraction), ImVec2(-1, ui.px(kProgressHeight)), "");
  std::error_code ignored;
  const bool replaces = !job.running && std::filesystem::exists(file, ignored);
  const std::string there =
      replaces ? fmt::format(words::common::existsAlready, std::filesystem::path(file).filename().string()) : "";
  const std::string said = job.running           ? fmt::format("{:.0f} %", 100 * job.fraction)
                           : job.outcome.empty() ? there
                                                 : job.outcome;
  textLine(ui, (dialog + ".said").c_str(), said, job.failed ? ui.theme.error : ui.theme.textQuiet);
  ui.probe.fact(dialog + ".outcome", job.running ? "running" : job.outcome);

  ButtonsAnswer answer;
  const float width = ui.px(120);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ui.px(24));
  const bool done = !job.running && !job.outcome.empty() && !job.failed;
  const auto& leave = done ? mainButton : button;
  const bool left = leave(ui, (dialog + ".close").c_str(), job.running ? words::common::cancel : words::common::close,
                          width, true, "");
  const bool dismiss = left || modalCancelled(ui) || (done && modalConfirmed(ui));
  ImGui::SameLine();
  const bool canStart = !job.running && !file.empty();
  const auto& begin = done ? button : mainButton;
  answer.start = begin(ui, (dialog + ".start").c_str(), replaces ? words::common::replace : words::rendering::render,
                       width, canStart, "");
  // What is there goes by the button alone, which says so.
  answer.start |= canStart && !done && !replaces && modalConfirmed(ui);
  (job.running ? answer.cancel : answer.close) = dismiss;
  return answer;
}

}  // namespace

void RenderDialog::show(std::string file) {
  file_ = std::move(file);
  open_ = opening_ = true;
}

RenderDialog::Answer RenderDialog::draw(Ui& ui, const RenderJob& job, const std::string& replaced,
                                        const std::function<void()>& rows) {
  Answer answer;
  if (!open_) return answer;
  if (!beginLastingModal(ui, title_, ImVec2(ui.px(480), 0), open_, opening_)) return answer;
  const std::string scrolled = id_ + ".rows";
  ImGui::BeginDisabled(job.running);
  beginModalRows(ui, scrolled.c_str(), heightBelowRows(ui));
  rows();
  endModalRows(scrolled.c_str());
  textField(ui, {id_ + "." + field_, fileWord_}, file_);
  answer.chooseFile = opening_ = chooseFileButton(ui, id_, file_);  // it comes back when the browser has gone
  ImGui::EndDisabled();
  const ButtonsAnswer pressed = progressAndButtons(ui, id_, job, replaced);
  answer.start = pressed.start;
  answer.cancel = pressed.cancel;
  if (pressed.close) closeModal(open_);
  endModal();
  return answer;
}

}  // namespace loomlight
