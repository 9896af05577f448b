#include "ui/dialogs/tile_dialog.h"

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/dialog_words.h"

namespace loomlight {

void TileDialog::show(std::string file) {
  file_ = std::move(file);
  size_.reset();
  open_ = opening_ = true;
}

TileDialog::Result TileDialog::draw(Ui& ui, const TileModel& model, double fewestPixels, const RenderJob& job) {
  Result result;
  if (!open_) return result;
  if (!beginLastingModal(ui, words::tile::title, ImVec2(ui.px(480), 0), open_, opening_)) return result;
  ImGui::BeginDisabled(job.running);
  beginModalRows(ui, "tile.rows", renderJobHeight(ui));
  hint(ui, words::tile::about);
  size_.draw(ui, "tile", model, fewestPixels);
  wholeNumberField(ui, {"tile.samples", words::tile::samples}, words::tile::perPixel, 1, 65536, samplesPerPixel_);
  textField(ui, {"tile.file", words::tile::file}, file_);
  result.chooseFile = opening_ = chooseFileButton(ui, "tile", file_);  // it comes back when the browser has gone
  endModalRows("tile.rows");
  ImGui::EndDisabled();
  const RenderJobAnswer answer = renderJobRows(ui, "tile", job, file_);
  result.start = answer.start && model.problem.empty();
  result.cancel = answer.cancel;
  if (answer.close) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  endModal();
  return result;
}

}  // namespace loomlight
