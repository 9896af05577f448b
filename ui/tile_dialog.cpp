#include "ui/tile_dialog.h"

#include <fmt/core.h>

#include "ui/fields.h"
#include "ui/modal.h"

namespace loomlight {

void TileDialog::show(std::string file) {
  file_ = std::move(file);
  open_ = opening_ = true;
}

TileDialog::Result TileDialog::draw(Ui& ui, const Progress& progress) {
  Result result;
  if (!open_) return result;
  const bool begin = opening_;
  opening_ = false;
  if (!beginModal(ui, "Tile for other programs", ImVec2(ui.px(480), 0), begin)) {
    open_ = false;
    result.cancel = progress.running;
    return result;
  }
  hint(ui,
       "One seamless tile as base colour, normal, height, opacity and yarn, for Blender, CLO, Substance and others. A "
       ".json beside them has its size in mm, mass and thickness.");
  ImGui::BeginDisabled(progress.running);
  wholeNumberField(ui, {"tile.size", "Longer side", "Of the tile."}, "px", 16, 16384, longestSide_);
  wholeNumberField(ui, {"tile.samples", "Samples", "Light paths through every pixel: more are smoother."}, "", 1, 65536,
                   samplesPerPixel_);
  textField(ui, {"tile.file", "File", "The .json; the maps are named after it."}, file_);
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(ImGui::GetContentRegionAvail().x * 0.44f + ui.px(16));
  result.chooseFile = button(ui, "tile.browse", "Choose\xE2\x80\xA6");
  ImGui::EndDisabled();
  ImGui::ProgressBar(static_cast<float>(progress.fraction), ImVec2(-1, ui.px(4)), "");
  ImGui::PushStyleColor(ImGuiCol_Text, progress.failed ? ui.theme.error : ui.theme.textQuiet);
  const std::string said = progress.running ? fmt::format("{:.0f} %", 100 * progress.fraction) : progress.outcome;
  ImGui::TextWrapped("%s", said.empty() ? " " : said.c_str());
  ImGui::PopStyleColor();
  ui.probe.fact("tile.outcome", progress.running ? "running" : progress.outcome);

  const float width = ui.px(120);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ui.px(24));
  const bool dismiss = button(ui, "tile.close", progress.running ? "Cancel" : "Close", width) || modalCancelled();
  ImGui::SameLine();
  result.start = button(ui, "tile.start", "Render", width, !progress.running && !file_.empty());
  if (dismiss && progress.running) {
    result.cancel = true;
  } else if (dismiss) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  endModal();
  return result;
}

}  // namespace loomlight
