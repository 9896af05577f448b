#include <fmt/format.h>

#include <filesystem>

#include "app/editor/session.h"
#include "app/export/draft_sheet.h"
#include "app/export/file_name.h"
#include "app/export/tile.h"
#include "app/export/weave_bitmap.h"
#include "core/base/error.h"
#include "core/fabric/weave/structure_edit.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/yarn/derived.h"
#include "render/transport/make_medium.h"
#include "ui/widgets/yarn_colours.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

WifSett settOf(const Fabric& fabric) {
  return {fabric.ends_per_cm, fabric.picks_per_cm, meanDiameter_mm(fabric, System::warp),
          meanDiameter_mm(fabric, System::weft)};
}

std::string summaryOf(const Fabric& fabric) {
  std::string summary = fmt::format("\xE2\x80\x9C{}\xE2\x80\x9D: {} ends, {} picks", fabric.name, fabric.weave.ends(),
                                    fabric.weave.picks());
  if (fabric.draft) {
    summary += fmt::format(", {} shafts", fabric.draft->shafts);
    summary += fabric.draft->liftplan.empty() ? fmt::format(", {} treadles", fabric.draft->treadles)
                                              : std::string(", with a liftplan");
  }
  if (fabric.wif && !fabric.wif->program.empty()) summary += fmt::format(". Written by {}", fabric.wif->program);
  return summary + ".";
}

}  // namespace

void Session::run(DraftCommand command) {
  switch (command) {
    case DraftCommand::structures:
      return structures_.show();
    case DraftCommand::fromPicture:
      return browse(FileTask::picture);
    case DraftCommand::exportWif:
      return browse(FileTask::exportWif);
    case DraftCommand::exportBitmap:
      return browse(FileTask::exportBitmap);
    case DraftCommand::exportDraft:
      return browse(FileTask::exportDraft);
    case DraftCommand::exportTile: {
      tile_.forget();
      return tileDialog_.show(freeFile(fileCalledAsCloth(" tile.json")).string());
    }
    default:
      place_ = placeInDraft();
      if (auto edited = runDraftCommand(command, *document_.fabric(), settings_.draft, draft_))
        edit(std::move(*edited));
  }
}

void Session::weavingOpened(Fabric fabric, const std::string& file, std::vector<WifWarning> warnings) {
  startOver(Document(std::move(fabric)));
  wifKept_ = document_.fabric();
  remember(file);
  std::vector<WifWarning> beyond;
  withWifSizes(*wifKept_, beyond);
  wifDialog_.show(
      {summaryOf(*wifKept_), wifSett(*wifKept_), settOf(*wifKept_), std::move(beyond), std::move(warnings)});
}

void Session::openPicture(const std::string& file) {
  pictureDialog_.await(fs::path(file).filename().string());
  pictures_.read(file);
  lookNextIn(file);
}

void Session::drawPicture(Ui& ui) {
  if (auto come = pictures_.take()) {
    if (come->source) {
      const Fabric& fabric = *document_.fabric();
      pictureDialog_.show(come->source, fabric.ends_per_cm / fabric.picks_per_cm);
    } else {
      pictureDialog_.close();
      if (come->woven) {
        // Only the weave: what else was edited meanwhile stays.
        Rewoven& woven = *come->woven;
        Fabric fabric = *document_.fabric();
        fabric.weave = std::move(woven.fabric.weave);
        fabric.draft = std::move(woven.fabric.draft);
        draft_.selection.reset();
        takeWeave({std::move(fabric), std::move(woven.remark)});
      } else {
        say("This picture cannot be used", come->problem);
      }
    }
  }
  const bool open = pictureDialog_.isOpen();
  if (auto order = pictureDialog_.draw(ui))
    pictures_.weave(std::move(*order), document_.fabric(), settings_.draft.loom);
  if (open && !pictureDialog_.isOpen()) pictures_.forget();
}

/// Another weave in place of the whole or of the selection.
void Session::takeWeave(Rewoven result) {
  place_ = placeInDraft();
  edit(std::move(result.fabric));
  draft_.remark = std::move(result.remark);
  if (!draft_.selection) draft_.cell = 0;
}

EditPlace Session::placeInDraft() const {
  return {EditPlace::Panel::draft, draft_.cell, draft_.origin.x, draft_.origin.y, 0, 0};
}

EditPlace Session::placeInInspector() const {
  return {EditPlace::Panel::inspector, 0, 0, 0, static_cast<int>(inspector_.page), inspector_.yarn};
}

void Session::goTo(const EditPlace& place) {
  if (place.panel == EditPlace::Panel::none) return;
  settings_.desk.panelsShown = true;
  if (place.panel == EditPlace::Panel::draft) {
    draft_.cell = place.cell;
    draft_.origin = ImVec2(place.originX, place.originY);
  } else {
    inspector_.page = static_cast<InspectorView::Page>(place.page);
    inspector_.yarn = place.yarn;
  }
}

void Session::exportTo(FileTask task, const std::string& file) {
  const DraftCorner corner{settings_.draft.startsRight(), settings_.draft.startsAtTop()};
  files_.exportTo(file, [task, file, corner, fabric = document_.fabric()]() -> std::vector<std::string> {
    if (task == FileTask::exportWif) return writeWifFabric(*fabric, file);
    if (task == FileTask::exportDraft)
      writeDraftSheet(file, *fabric, corner);
    else
      writeWeaveBitmap(file, fabric->weave);
    return {};
  });
}

void Session::drawStructures(Ui& ui) {
  if (!structures_.isOpen()) return;
  const std::vector<ImVec4> colours = yarnColours(withSecondYarn(*document_.fabric()));
  const ImVec4 darkLight[2] = {colours[0], colours[1]};
  const auto structure = structures_.draw(ui, draft_.selection, darkLight);
  if (!structure) return;
  takeWeave(withStructure(*document_.fabric(), draft_.selection, *structure, settings_.draft.loom));
}

void Session::drawTile(Ui& ui) {
  if (tile_.isRunning()) ui.wakeWithin(0.1);
  if (tile_.follow().has_value()) views_.pause(false);
  const std::string before = tileDialog_.file();
  const TileDialog::Result result = tileDialog_.draw(ui, tile_.progress());
  if (tileDialog_.file() != before) tile_.forget();
  if (result.chooseFile) browse(FileTask::exportTile);
  if (result.cancel) tile_.cancel();
  if (!result.start || tile_.isRunning()) return;
  const fs::path file(tileDialog_.file());
  Fabric fabric = *document_.fabric();
  fabric.render.samplesPerPixel = tileDialog_.samplesPerPixel();
  views_.pause(true);
  tile_.start([fabric = std::move(fabric), stem = (file.parent_path() / file.stem()).string(),
               side = tileDialog_.longestSide()](const Task& task) -> std::optional<std::string> {
    const auto tile = makeTile(fabric, stem, side, defaultMemoryLimit_bytes(), task);
    if (!tile) return std::nullopt;
    return fmt::format("Written: {}.json and {} maps beside it", stem, tile->files.size() - 1);
  });
}

void Session::drawDraftDialogs(Ui& ui) {
  drawStructures(ui);
  // The browser stands in for the dialog while it names the file.
  if (!browser_.isOpen()) drawTile(ui);
  drawPicture(ui);
  const auto sizes = wifDialog_.draw(ui);
  if (!sizes) return;
  std::vector<WifWarning> said;  // the dialog has them already
  edit(*sizes == WifSizeChoice::file ? withWifSizes(*wifKept_, said) : *wifKept_);
}

}  // namespace loomlight
