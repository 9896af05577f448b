#include "app/editor/controllers/tile_controller.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "app/export/tile.h"
#include "render/transport/make_medium.h"
#include "ui/words/dialog_words.h"

namespace loomlight {

void TileController::show(std::string file, const std::shared_ptr<const Fabric>& fabric) {
  rendering_.forget();
  sizes_.ask(fabric);
  dialog_.show(std::move(file));
}

void TileController::setFile(const std::string& file) {
  dialog_.setFile(file);
  rendering_.forget();
}

void TileController::follow(Ui& ui, ViewService& seen) {
  rendering_.follow(ui, seen);
}

bool TileController::draw(Ui& ui, const Fabric& fabric, ViewService& seen) {
  const std::string before = dialog_.file();
  const TileDialog::Result result = dialog_.draw(ui, sizes_.newest(), kFewestPixelsPerYarn, rendering_.progress());
  if (dialog_.file() != before) rendering_.forget();
  if (result.cancel) rendering_.cancel();
  if (!result.start || rendering_.isRunning()) return result.chooseFile;
  const std::filesystem::path file(dialog_.file());
  Fabric sampled = fabric;
  sampled.render.samplesPerPixel = dialog_.samplesPerPixel();
  rendering_.start(
      [fabric = std::move(sampled), stem = (file.parent_path() / file.stem()).string(),
       order = TileOrder{dialog_.longestSide(), dialog_.joinsTwist()}](const Task& task) -> std::optional<std::string> {
        const auto tile = makeTile(fabric, stem, order, defaultMemoryLimit_bytes(), task);
        if (!tile) return std::nullopt;
        return fmt::format(words::tile::written, stem, tile->files.size() - 1);
      },
      seen);
  return result.chooseFile;
}

}  // namespace loomlight
