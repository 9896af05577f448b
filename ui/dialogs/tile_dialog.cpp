#include "ui/dialogs/tile_dialog.h"

#include <fmt/core.h>

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"
#include "ui/words/dialog_words.h"

namespace loomlight {

void TileDialog::show(std::string file) {
  file_ = std::move(file);
  ownSide_.reset();
  open_ = opening_ = true;
}

/// How much cloth it is, and how finely it is shown. All rows are there from the beginning: what comes to be known
/// moves nothing.
void TileDialog::sizeRows(Ui& ui, const TileModel& model, double fewestPixels) {
  switchField(ui, {"tile.twist", words::tile::twist}, joinsTwist_);
  const std::optional<TileSize>& size = joinsTwist_ ? model.joined : model.plain;
  const auto known = [&](const std::string& text) { return size ? text : std::string("\xE2\x80\x93"); };
  const TileSize s = size.value_or(TileSize{});
  readout(ui, {"tile.threads", words::tile::threads}, known(fmt::format("{} \xC3\x97 {}", s.ends, s.picks)));
  readout(ui, {"tile.repeats", words::tile::repeats},
          known(fmt::format("{} \xC3\x97 {}", s.repeatsAcross, s.repeatsDown)));
  readout(ui, {"tile.size_mm", words::tile::size},
          known(fmt::format("{:.1f} \xC3\x97 {:.1f} mm", s.width_mm, s.height_mm)));
  longestSide_ = ownSide_.value_or(s.usualSide);
  if (wholeNumberField(ui, {"tile.size", words::tile::longerSide}, "px", 16, 16384, longestSide_))
    ownSide_ = longestSide_;
  const double perYarn = longestSide_ / s.yarnsAlongLonger;
  readout(ui, {"tile.per_thread", words::tile::perThread}, known(fmt::format("{:.1f} px", perYarn)));
  const bool few = size && perYarn < fewestPixels;
  hint(ui,
       !model.problem.empty() ? model.problem
       : few                  ? fmt::format(words::tile::tooFew, fewestPixels)
                              : std::string(" "),
       ui.theme.warning);
  ui.probe.fact("tile.few_pixels", few ? "yes" : "no");
}

TileDialog::Result TileDialog::draw(Ui& ui, const TileModel& model, double fewestPixels, const RenderJob& job) {
  Result result;
  if (!open_) return result;
  if (!beginModal(ui, words::tile::title, ImVec2(ui.px(480), 0), open_, opening_)) {
    result.cancel = job.running;
    return result;
  }
  hint(ui, words::tile::about);
  ImGui::BeginDisabled(job.running);
  sizeRows(ui, model, fewestPixels);
  wholeNumberField(ui, {"tile.samples", words::tile::samples}, words::tile::perPixel, 1, 65536, samplesPerPixel_);
  textField(ui, {"tile.file", words::tile::file}, file_);
  result.chooseFile = chooseFileButton(ui, "tile", file_);
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
