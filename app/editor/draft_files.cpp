#include <fmt/format.h>

#include <filesystem>

#include "app/commands/weave_bitmap.h"
#include "app/editor/session.h"
#include "core/base/error.h"
#include "core/fabric/derived.h"
#include "core/fabric/wif_fabric.h"

namespace loomlight {
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

void Session::openBitmap(const std::string& file) {
  try {
    Rewoven result = rewoven(*document_.fabric(), readWeaveBitmap(file), settings_.draft.loom);
    edit(std::move(result.fabric));
    draft_.remark = std::move(result.remark);
    draft_.cell = 0;
    draft_.selection.reset();
  } catch (const InputError& error) {
    say("This picture cannot be used", error.what());
  }
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

void Session::drawDraftDialogs(Ui& ui) {
  const auto sizes = wifDialog_.draw(ui);
  if (!sizes) return;
  std::vector<std::string> beyond;
  edit(*sizes == WifSizeChoice::file ? withWifSizes(*wifKept_, beyond) : *wifKept_);
  for (const std::string& warning : beyond) refusal_ = warning;
}

}  // namespace loomlight
