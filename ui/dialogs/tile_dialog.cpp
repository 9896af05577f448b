#include "ui/dialogs/tile_dialog.h"

#include <fmt/core.h>

#include "ui/widgets/fields.h"
#include "ui/widgets/modal.h"

namespace loomlight {

void TileDialog::show(std::string file) {
  file_ = std::move(file);
  ownSide_.reset();
  open_ = opening_ = true;
}

/// How much cloth it is, and how finely it is shown. All rows are there from the beginning: what comes to be known
/// moves nothing.
void TileDialog::sizeRows(Ui& ui, const TileModel& model, double fewestPixels) {
  switchField(
      ui,
      {"tile.twist", "Twist joins",
       "On: the twist of every yarn comes round as well, so that each fibre goes on in the next tile; that may "
       "take several repeats. Off: weave and colours alone come round, and at the edges fibres do not quite meet."},
      joinsTwist_);
  const std::optional<TileSize>& size = joinsTwist_ ? model.joined : model.plain;
  const auto known = [&](const std::string& text) { return size ? text : std::string("\xE2\x80\x93"); };
  const TileSize s = size.value_or(TileSize{});
  readout(ui, {"tile.threads", "Threads", "Ends and picks of the tile"},
          known(fmt::format("{} \xC3\x97 {}", s.ends, s.picks)));
  readout(ui, {"tile.repeats", "Weave repeats", "Across and up the tile"},
          known(fmt::format("{} \xC3\x97 {}", s.repeatsAcross, s.repeatsDown)));
  readout(ui, {"tile.size_mm", "Size", "Of the tile, as cloth"},
          known(fmt::format("{:.1f} \xC3\x97 {:.1f} mm", s.width_mm, s.height_mm)));
  longestSide_ = ownSide_.value_or(s.usualSide);
  if (wholeNumberField(
          ui, {"tile.size", "Longer side", "Of the tile. At first 16 pixels for each thread, and 1024 at least."}, "px",
          16, 16384, longestSide_))
    ownSide_ = longestSide_;
  const double perYarn = longestSide_ / s.yarnsAlongLonger;
  readout(ui, {"tile.per_thread", "Per thread", "Pixels across the finer of its threads"},
          known(fmt::format("{:.1f} px", perYarn)));
  const bool few = size && perYarn < fewestPixels;
  hint(ui,
       !model.problem.empty() ? model.problem
       : few                  ? fmt::format("Below {:g} pixels a thread is a mere colour, no yarn.", fewestPixels)
                              : std::string(" "),
       ui.theme.warning);
  ui.probe.fact("tile.few_pixels", few ? "yes" : "no");
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
  sizeRows(ui, model, fewestPixels);
  wholeNumberField(ui, {"tile.samples", "Samples", "Light paths through every pixel: more are smoother."}, "per px", 1,
                   65536, samplesPerPixel_);
  textField(ui, {"tile.file", "File", "The .json; the maps are named after it."}, file_);
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
