#include "app/editor/controllers/file_controller.h"

#include <fmt/core.h>

#include "app/editor/model/user_folders.h"
#include "app/export/program_folders.h"
#include "ui/words/file_words.h"
#include "ui/words/preset_words.h"

namespace loomlight {
namespace {

struct Asked {
  FileTask task;
  FileBrowser::Purpose purpose;
  const char* title;
  std::vector<std::string> endings;
};

/// All that Session::openFile() knows: cloths, drafts, pictures to weave, environments, meshes, colours, lamps.
std::vector<std::string> endingsThatOpen() {
  return {".loomlight", ".json", ".wif", ".plm", ".dtx", ".twa", ".png", ".exr", ".obj", ".ply", ".off",
          ".ase",       ".aco",  ".gpl", ".csv", ".cxf", ".qtx", ".txt", ".spd", ".icc", ".icm"};
}

const Asked& askedFor(FileTask task) {
  using Purpose = FileBrowser::Purpose;
  static const Asked kAsked[] = {
      {FileTask::open, Purpose::open, words::files::open, endingsThatOpen()},
      {FileTask::saveAs, Purpose::save, words::files::saveCloth, {".loomlight", ".json"}},
      {FileTask::mesh, Purpose::open, words::files::chooseMesh, {".obj", ".ply", ".off"}},
      {FileTask::environment, Purpose::open, words::files::chooseEnvironment, {".exr"}},
      {FileTask::snapshot, Purpose::save, words::files::snapshotFile, {".png", ".exr"}},
      {FileTask::profile, Purpose::open, words::files::chooseProfile, {".icc", ".icm"}},
      {FileTask::picture, Purpose::open, words::files::choosePicture, {".png"}},
      {FileTask::exportWif, Purpose::save, words::files::exportWif, {".wif"}},
      {FileTask::exportDraft, Purpose::save, words::files::exportDraft, {".pdf", ".png"}},
      {FileTask::exportTile, Purpose::save, words::files::tileFile, {".json"}},
      {FileTask::handover, Purpose::folder, words::files::handoverFolder, {}},
      {FileTask::sheet, Purpose::save, words::files::sheetFile, {".pdf", ".png"}},
      {FileTask::colourwaySheet, Purpose::save, words::files::colourwaysFile, {".pdf", ".png"}},
      {FileTask::exportBitmap, Purpose::save, words::files::exportWeave, {".png", ".tif", ".bmp"}},
  };
  for (const Asked& asked : kAsked)
    if (asked.task == task) return asked;
  return kAsked[0];
}

}  // namespace

void FileController::browse(FileTask task, const std::filesystem::path& start) {
  task_ = task;
  previews_.forget();  // files change between two looks at them
  std::vector<FileBrowser::Bookmark> bookmarks = {
      {words::files::home, homeFolder()}, {words::presets::title, presetFolder()}, {words::files::computer, "/"}};
  if (const auto samples = sampleFolder()) bookmarks.push_back({words::files::samples, *samples});
  const Asked& asked = askedFor(task);
  browser_.show(asked.purpose, asked.title, asked.endings, start, bookmarks);
}

std::optional<FileController::Chosen> FileController::drawBrowser(Ui& ui) {
  if (!browser_.isOpen()) return std::nullopt;
  auto file = browser_.draw(ui, previews_.of(browser_.chosen()));
  if (!file) return std::nullopt;
  return Chosen{std::exchange(task_, FileTask::none), std::move(*file)};
}

std::optional<FileService::Result> FileController::drawBusy(Ui& ui) {
  auto result = service_.take();
  std::optional<BusyWork> work;
  if (const auto& busy = service_.busy()) {
    const std::string name = std::filesystem::path(busy->file).filename().string();
    work = BusyWork{service_.isReading()   ? fmt::format(words::files::opening, name)
                    : service_.canCancel() ? fmt::format(words::files::writing, name)
                                           : fmt::format(words::files::finishing, name),
                    service_.fraction(), service_.canCancel()};
  }
  if (busy_.draw(ui, work)) service_.cancel();
  return result;
}

void FileController::placeDropped(const std::optional<int>& yarn) {
  for (std::string& file : arriving_) dropped_.push_back({std::move(file), yarn});
  arriving_.clear();
}

std::optional<FileController::Dropped> FileController::takeDropped() {
  if (dropped_.empty()) return std::nullopt;
  std::optional<Dropped> next(std::move(dropped_.front()));
  dropped_.pop_front();
  return next;
}

}  // namespace loomlight
