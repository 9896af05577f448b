#include "app/editor/controllers/file_controller.h"

#include <fmt/core.h>

#include "app/editor/model/user_folders.h"
#include "app/export/program_folders.h"

namespace loomlight {
namespace {

struct Asked {
  FileTask task;
  FileBrowser::Purpose purpose;
  const char* title;
  std::vector<std::string> endings;
};

/// All that Session::openFile() knows: cloths, drafts, pictures to weave, environments, meshes, colours.
std::vector<std::string> endingsThatOpen() {
  return {".loomlight", ".json", ".wif", ".dtx", ".png", ".exr", ".obj", ".ply", ".off",
          ".ase",       ".aco",  ".gpl", ".csv", ".cxf", ".qtx", ".txt", ".icc", ".icm"};
}

const Asked& askedFor(FileTask task) {
  using Purpose = FileBrowser::Purpose;
  static const Asked kAsked[] = {
      {FileTask::open, Purpose::open, "Open", endingsThatOpen()},
      {FileTask::saveAs, Purpose::save, "Save the cloth", {".loomlight", ".json"}},
      {FileTask::mesh, Purpose::open, "Choose a mesh", {".obj", ".ply", ".off"}},
      {FileTask::environment, Purpose::open, "Choose an environment", {".exr"}},
      {FileTask::snapshot, Purpose::save, "Where the snapshot goes", {".png", ".exr"}},
      {FileTask::profile, Purpose::open, "Choose a colour profile", {".icc", ".icm"}},
      {FileTask::picture, Purpose::open, "Choose a picture", {".png"}},
      {FileTask::exportWif, Purpose::save, "Export as WIF draft", {".wif"}},
      {FileTask::exportDraft, Purpose::save, "Export the draft for print", {".pdf", ".png"}},
      {FileTask::exportTile, Purpose::save, "Where the tile goes", {".json"}},
      {FileTask::handover, Purpose::folder, "Where the hand-over goes", {}},
      {FileTask::sheet, Purpose::save, "Where the cloth sheet goes", {".pdf", ".png"}},
      {FileTask::colourwaySheet, Purpose::save, "Where the colourways go", {".pdf", ".png"}},
      {FileTask::exportBitmap, Purpose::save, "Export the weave", {".png", ".tif", ".bmp"}},
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
      {"Home", homeFolder()}, {"Presets", presetFolder()}, {"Computer", "/"}};
  if (const auto samples = sampleFolder()) bookmarks.push_back({"Samples", *samples});
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
  std::optional<std::string> text;
  if (const auto& busy = service_.busy()) {
    const char* does = service_.isReading() ? "Opening" : service_.canCancel() ? "Writing" : "Finishing";
    text = fmt::format("{} {}\xE2\x80\xA6", does, std::filesystem::path(busy->file).filename().string());
  }
  if (busy_.draw(ui, text, service_.canCancel())) service_.cancel();
  return result;
}

std::optional<std::string> FileController::takeDropped() {
  if (dropped_.empty()) return std::nullopt;
  std::optional<std::string> file(std::move(dropped_.front()));
  dropped_.pop_front();
  return file;
}

}  // namespace loomlight
