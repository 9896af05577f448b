#include "ui/dialogs/handover_dialog.h"

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/dialog_words.h"

namespace loomlight {

void HandoverDialog::show(std::string folder) {
  folder_ = std::move(folder);
  size_.reset();
  open_ = opening_ = true;
}

/// Returns whether a folder is to be chosen.
bool HandoverDialog::rows(Ui& ui, const HandoverModel& model) {
  hint(ui, words::handover::about);
  size_.draw(ui, "handover", model.tile, model.fewestPixels);
  wholeNumberField(ui, {"handover.samples", words::tile::samples}, words::tile::perPixel, 1, 65536, samplesPerPixel_);
  wholeNumberField(ui, {"handover.measure", words::handover::measure}, words::handover::paths, 1, 65536,
                   measuringSamples_);
  if (model.colourways == 0) allColourways_ = false;
  ImGui::BeginDisabled(model.colourways == 0);
  switchField(ui, {"handover.colourways", words::handover::colourways}, allColourways_);
  ImGui::EndDisabled();
  textField(ui, {"handover.folder", words::handover::folder}, folder_);
  return chooseFileButton(ui, "handover", folder_);
}

HandoverDialog::Result HandoverDialog::draw(Ui& ui, const HandoverModel& model, const RenderJob& job) {
  Result result;
  if (!open_) return result;
  if (!beginLastingModal(ui, words::handover::title, ImVec2(ui.px(480), 0), open_, opening_)) return result;
  ImGui::BeginDisabled(job.running);
  beginModalRows(ui, "handover.rows", renderJobHeight(ui));
  result.chooseFolder = opening_ = rows(ui, model);  // it comes back when the browser has gone
  endModalRows("handover.rows");
  ImGui::EndDisabled();
  const RenderJobAnswer answer = renderJobRows(ui, "handover", job, model.sidecar);
  result.start = answer.start && model.tile.problem.empty();
  result.cancel = answer.cancel;
  if (answer.close) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  endModal();
  return result;
}

}  // namespace loomlight
