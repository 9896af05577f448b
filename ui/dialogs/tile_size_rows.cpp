#include "ui/dialogs/tile_size_rows.h"

#include <fmt/core.h>

#include "ui/widgets/fields.h"
#include "ui/words/dialog_words.h"
#include "ui/words/panel_words.h"

namespace loomlight {
namespace {

/// Some twists come round after hundreds of repeats only: such a tile is a piece of cloth.
bool isFarLarger(const TileSize& joined, const TileSize& plain) {
  constexpr int kFew = 8;
  return joined.ends > kFew * plain.ends || joined.picks > kFew * plain.picks;
}

}  // namespace

void TileSizeRows::draw(Ui& ui, const std::string& dialog, const TileModel& model, double fewestPixels) {
  joinsTwist_ = ownTwist_.value_or(!model.joined || !model.plain || !isFarLarger(*model.joined, *model.plain));
  if (switchField(ui, {dialog + ".twist", words::tile::twist}, joinsTwist_)) ownTwist_ = joinsTwist_;
  const std::optional<TileSize>& size = joinsTwist_ ? model.joined : model.plain;
  const auto known = [&](const std::string& text) { return size ? text : std::string(words::panels::none); };
  const TileSize s = size.value_or(TileSize{});
  readout(ui, {dialog + ".threads", words::tile::threads}, known(fmt::format("{} \xC3\x97 {}", s.ends, s.picks)));
  readout(ui, {dialog + ".repeats", words::tile::repeats},
          known(fmt::format("{} \xC3\x97 {}", s.repeatsAcross, s.repeatsDown)));
  readout(ui, {dialog + ".size_mm", words::tile::size},
          known(fmt::format("{:.1f} \xC3\x97 {:.1f} mm", s.width_mm, s.height_mm)));
  longestSide_ = ownSide_.value_or(s.usualSide);
  if (wholeNumberField(ui, {dialog + ".size", words::tile::longerSide}, "px", 16, 16384, longestSide_))
    ownSide_ = longestSide_;
  const double perYarn = longestSide_ / s.yarnsAlongLonger;
  readout(ui, {dialog + ".per_thread", words::tile::perThread}, known(fmt::format("{:.1f} px", perYarn)));
  const bool few = size && perYarn < fewestPixels;
  hint(ui,
       !model.problem.empty() ? model.problem
       : few                  ? fmt::format(words::tile::tooFew, fewestPixels)
                              : std::string(" "),
       ui.theme.warning);
  ui.probe.fact(dialog + ".few_pixels", few ? "yes" : "no");
}

}  // namespace loomlight
