#include "ui/dialogs/dialogs.h"

#include <fmt/core.h>

#include "ui/widgets/member_fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/picture_words.h"

namespace loomlight {

void MessageDialog::show(std::string title, std::string text, std::vector<std::string> answers, int enter) {
  title_ = std::move(title);
  text_ = std::move(text);
  answers_ = std::move(answers);
  enter_ = enter;
  open_ = opening_ = true;
}

std::optional<int> MessageDialog::draw(Ui& ui) {
  if (!open_) return std::nullopt;
  std::optional<int> answer;
  if (!beginLastingModal(ui, (title_ + "##message").c_str(), ImVec2(ui.px(480), 0), open_, opening_))
    return std::nullopt;
  ui.probe.fact("message", text_);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text_.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(0, ui.px(8)));
  const float width = ui.px(120);
  const float count = static_cast<float>(answers_.size());
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ui.px(16) - count * width - (count - 1) * ui.px(8));
  for (int i = 0; i < static_cast<int>(answers_.size()); ++i) {
    if (i > 0) ImGui::SameLine();
    const auto& press = i == enter_ ? mainButton : button;
    if (press(ui, fmt::format("message.answer_{}", i).c_str(), answers_[static_cast<size_t>(i)].c_str(), width, true,
              ""))
      answer = i;
  }
  if (modalCancelled(ui)) answer = 0;
  if (modalConfirmed(ui)) answer = enter_;
  if (answer) closeModal(open_);
  endModal();
  return answer;
}

SnapshotDialog::SnapshotDialog() : dialog_("snapshot", words::snapshot::title, "file", words::snapshot::file) {}

void SnapshotDialog::show(const RenderSettings& settings, std::string file) {
  settings_ = settings;
  dialog_.show(std::move(file));
}

SnapshotDialog::Result SnapshotDialog::draw(Ui& ui, const ClothInView& seen, const RenderJob& job) {
  std::optional<RenderSettings> edited;
  const RenderDialog::Answer answer = dialog_.draw(ui, job, [&] {
    bool changed = snapshotOptionRows(ui, options_, settings_, seen);
    changed |= memberField(ui, "snapshot", settings_, &RenderSettings::samplesPerPixel);
    if (changed) edited = settings_;
  });
  return {edited, answer.chooseFile, answer.start, answer.cancel};
}

}  // namespace loomlight
