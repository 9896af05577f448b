#include "ui/dialogs/tile_dialog.h"

#include "ui/widgets/fields.h"
#include "ui/words/dialog_words.h"

namespace loomlight {

TileDialog::TileDialog() : dialog_("tile", words::tile::title, "file", words::tile::file) {}

void TileDialog::show(std::string file) {
  size_.reset();
  dialog_.show(std::move(file));
}

TileDialog::Result TileDialog::draw(Ui& ui, const TileModel& model, double fewestPixels, const RenderJob& job) {
  Result result = dialog_.draw(ui, job, [&] {
    hint(ui, words::tile::about);
    size_.draw(ui, "tile", model, fewestPixels);
    wholeNumberField(ui, {"tile.samples", words::tile::samples}, words::tile::perPixel, 1, 65536, samplesPerPixel_);
  });
  result.start = result.start && model.problem.empty();
  return result;
}

}  // namespace loomlight
