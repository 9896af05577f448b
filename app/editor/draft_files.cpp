#include <fmt/format.h>

#include <filesystem>

#include "app/commands/weave_bitmap.h"
#include "app/editor/session.h"
#include "core/base/error.h"
#include "core/fabric/derived.h"
#include "core/fabric/wif_fabric.h"
#include "render/film/image.h"
#include "ui/yarn_colours.h"

namespace loomlight {
namespace {

WifSett settOf(const Fabric& fabric) {
  return {fabric.ends_per_cm, fabric.picks_per_cm, meanDiameter_mm(fabric, System::warp),
          meanDiameter_mm(fabric, System::weft)};
}

/// On white where it is transparent, as a picture is seen on paper.
Raster rasterOf(const Pixels8& pixels) {
  Raster raster{pixels.width, pixels.height, {}};
  const auto channels = static_cast<size_t>(pixels.channels);
  raster.pixels.reserve(pixels.bytes.size() / channels);
  for (size_t i = 0; i + channels <= pixels.bytes.size(); i += channels) {
    const int alpha = channels == 4 ? pixels.bytes[i + 3] : 255;
    const auto over = [&](size_t c) {
      return static_cast<uint8_t>((pixels.bytes[i + c] * alpha + 255 * (255 - alpha) + 127) / 255);
    };
    raster.pixels.push_back({over(0), over(1), over(2)});
  }
  return raster;
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
    default:
      if (auto edited = runDraftCommand(command, *document_.fabric(), settings_.draft, draft_))
        edit(std::move(*edited));
  }
}

void Session::openWeaving(const std::string& file) {
  try {
    WifImport import = readWifFabric(file, *document_.fabric(), WifSizeChoice::keep);
    startOver(Document(std::move(import.fabric)));
    wifKept_ = document_.fabric();
    settings_.folder = std::filesystem::absolute(file).parent_path().string();
    wifDialog_.show({summaryOf(*wifKept_), wifSett(*wifKept_), settOf(*wifKept_), std::move(import.warnings)});
  } catch (const InputError& error) {
    say("This file cannot be opened", error.what());
  }
}

void Session::openPicture(const std::string& file) {
  try {
    const Fabric& fabric = *document_.fabric();
    pictureDialog_.show(rasterOf(readPng(file)), std::filesystem::path(file).filename().string(),
                        fabric.ends_per_cm / fabric.picks_per_cm);
    settings_.folder = std::filesystem::absolute(file).parent_path().string();
  } catch (const InputError& error) {
    say("This picture cannot be used", error.what());
  }
}

/// Another weave in place of the whole or of the selection.
void Session::takeWeave(Rewoven result) {
  edit(std::move(result.fabric));
  draft_.remark = std::move(result.remark);
  if (!draft_.selection) draft_.cell = 0;
}

void Session::exportTo(FileTask task, const std::string& file) {
  try {
    std::string text = "Written: " + file;
    if (task == FileTask::exportWif) {
      for (const std::string& remark : writeWifFabric(*document_.fabric(), file)) text += "\n\n" + remark;
    } else {
      writeWeaveBitmap(file, document_.fabric()->weave);
    }
    settings_.folder = std::filesystem::absolute(file).parent_path().string();
    say("Exported", text);
  } catch (const InputError& error) {
    say("The file could not be written", error.what());
  }
}

void Session::drawStructures(Ui& ui) {
  const std::vector<ImVec4> colours = yarnColours(*document_.fabric());
  const ImVec4 darkLight[2] = {colours.front(), colours.size() > 1 ? colours[1] : colours.front()};
  const auto structure = structures_.draw(ui, draft_.selection, darkLight);
  if (!structure) return;
  takeWeave(withStructure(*document_.fabric(), draft_.selection, *structure, settings_.draft.loom));
}

void Session::drawDraftDialogs(Ui& ui) {
  drawStructures(ui);
  if (auto weave = pictureDialog_.draw(ui)) {
    draft_.selection.reset();
    takeWeave(rewoven(*document_.fabric(), std::move(*weave), settings_.draft.loom));
  }
  const auto sizes = wifDialog_.draw(ui);
  if (!sizes) return;
  std::vector<std::string> beyond;
  edit(*sizes == WifSizeChoice::file ? withWifSizes(*wifKept_, beyond) : *wifKept_);
  for (const std::string& warning : beyond) refusal_ = warning;
}

}  // namespace loomlight
