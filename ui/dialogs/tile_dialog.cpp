#include "ui/dialogs/tile_dialog.h"

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"

namespace loomlight {

void TileDialog::show(std::string file) {
  file_ = std::move(file);
  size_.reset();
  open_ = opening_ = true;
}

TileDialog::Result TileDialog::draw(Ui& ui, const TileModel& model, double fewestPixels, const RenderJob& job) {
  Result result;
  if (!open_) return result;
  if (!beginModal(ui, "Texture tile", ImVec2(ui.px(480), 0), open_, opening_)) {
    result.cancel = job.running;
    return result;
  }
  hint(ui,
       "One seamless tile as base colour, normal, height, opacity and yarn, for Blender, CLO, Substance and others. A "
       ".json beside them has its size in mm, mass and thickness.");
  ImGui::BeginDisabled(job.running);
  size_.draw(ui, "tile", model, fewestPixels);
  wholeNumberField(ui, {"tile.samples", "Samples", "Light paths through every pixel: more are smoother."}, "per px", 1,
                   65536, samplesPerPixel_);
  textField(ui, {"tile.file", "File", "The .json; the maps are named after it."}, file_);
  result.chooseFile = opening_ = chooseFileButton(ui, "tile", file_);  // it comes back when the browser has gone
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
