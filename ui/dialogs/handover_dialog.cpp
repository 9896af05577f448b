#include "ui/dialogs/handover_dialog.h"

#include "ui/widgets/fields.h"
#include "ui/words/dialog_words.h"

namespace loomlight {

HandoverDialog::HandoverDialog() : dialog_("handover", words::handover::title, "folder", words::handover::folder) {}

void HandoverDialog::show(std::string folder) {
  size_.reset();
  dialog_.show(std::move(folder));
}

void HandoverDialog::rows(Ui& ui, const HandoverModel& model) {
  hint(ui, words::handover::about);
  size_.draw(ui, "handover", model.tile, model.fewestPixels);
  wholeNumberField(ui, {"handover.samples", words::tile::samples}, words::tile::perPixel, 1, 65536, samplesPerPixel_);
  wholeNumberField(ui, {"handover.measure", words::handover::measure}, words::handover::paths, 1, 65536,
                   measuringSamples_);
  if (model.colourways == 0) allColourways_ = false;
  ImGui::BeginDisabled(model.colourways == 0);
  switchField(ui, {"handover.colourways", words::handover::colourways}, allColourways_);
  ImGui::EndDisabled();
}

HandoverDialog::Result HandoverDialog::draw(Ui& ui, const HandoverModel& model, const RenderJob& job) {
  const RenderDialog::Answer answer = dialog_.draw(ui, job, model.sidecar, [&] { rows(ui, model); });
  return {answer.chooseFile, answer.start && model.tile.problem.empty(), answer.cancel};
}

}  // namespace loomlight
