#include "ui/dialogs/tile_size_rows.h"

#include <fmt/core.h>

#include "ui/widgets/fields.h"

namespace loomlight {

void TileSizeRows::draw(Ui& ui, const std::string& dialog, const TileModel& model, double fewestPixels) {
  switchField(
      ui,
      {dialog + ".twist", "Twist joins",
       "On: the twist of every yarn comes round as well, so that each fibre goes on in the next tile; that may "
       "take several repeats. Off: weave and colours alone come round, and at the edges fibres do not quite meet."},
      joinsTwist_);
  const std::optional<TileSize>& size = joinsTwist_ ? model.joined : model.plain;
  const auto known = [&](const std::string& text) { return size ? text : std::string("\xE2\x80\x93"); };
  const TileSize s = size.value_or(TileSize{});
  readout(ui, {dialog + ".threads", "Threads", "Ends and picks of the tile"},
          known(fmt::format("{} \xC3\x97 {}", s.ends, s.picks)));
  readout(ui, {dialog + ".repeats", "Weave repeats", "Across and up the tile"},
          known(fmt::format("{} \xC3\x97 {}", s.repeatsAcross, s.repeatsDown)));
  readout(ui, {dialog + ".size_mm", "Size", "Of the tile, as cloth"},
          known(fmt::format("{:.1f} \xC3\x97 {:.1f} mm", s.width_mm, s.height_mm)));
  longestSide_ = ownSide_.value_or(s.usualSide);
  if (wholeNumberField(
          ui, {dialog + ".size", "Longer side", "Of the tile. At first 16 pixels for each thread, and 1024 at least."},
          "px", 16, 16384, longestSide_))
    ownSide_ = longestSide_;
  const double perYarn = longestSide_ / s.yarnsAlongLonger;
  readout(ui, {dialog + ".per_thread", "Per thread", "Pixels across the finer of its threads"},
          known(fmt::format("{:.1f} px", perYarn)));
  const bool few = size && perYarn < fewestPixels;
  hint(ui,
       !model.problem.empty() ? model.problem
       : few                  ? fmt::format("Below {:g} pixels a thread is a mere colour, no yarn.", fewestPixels)
                              : std::string(" "),
       ui.theme.warning);
  ui.probe.fact(dialog + ".few_pixels", few ? "yes" : "no");
}

}  // namespace loomlight
