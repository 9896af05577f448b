#include <fmt/core.h>

#include <filesystem>

#include "app/editor/model/left_work.h"
#include "app/editor/model/sample_fabric.h"
#include "app/editor/model/user_folders.h"
#include "app/editor/session.h"
#include "app/export/file_name.h"
#include "app/export/program_folders.h"

namespace loomlight {
namespace fs = std::filesystem;
namespace {

fs::path absolute(const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);  // fails where the working directory is gone
  return error ? fs::path(file) : whole.lexically_normal();
}

}  // namespace

void Session::lookNextIn(const std::string& fileThere) {
  settings_.folder = absolute(fileThere).parent_path().string();
}

void Session::remember(const std::string& file) {
  lookNextIn(file);
  loomlight::remember(settings_.recent, absolute(file).string());
}

void Session::openRecent(const std::string& file) {
  lookFor(settings_.recent);
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) return openFile(file);
  pendingFile_ = file;
  ask(Question::forgetRecent, "This file is missing", file + " is not there any more.",
      {"Keep in the list", "Forget it"}, 0);
}

void Session::openFabric(const std::string& file) {
  files_.open(FileDesk::Work::open, file, document_.fabric(), document_.state());
}

void Session::drop(const std::vector<std::string>& files) {
  dropped_.insert(dropped_.end(), files.begin(), files.end());
}

void Session::openDropped() {
  while (!dropped_.empty() && !dialogIsOpen()) {
    const std::string file = std::move(dropped_.front());
    dropped_.pop_front();
    openFile(file);
  }
}

void Session::openFile(const std::string& file) {
  const std::string extension = lowerExtension(file);
  if (extension == ".obj" || extension == ".ply" || extension == ".off") {
    Fabric fabric = *document_.fabric();
    fabric.drape.kind = DrapeKind::mesh;
    fabric.drape.file = file;
    edit(std::move(fabric));
    viewport_.fitWanted = true;
  } else if (extension == ".exr") {
    Fabric fabric = *document_.fabric();
    fabric.light.kind = LightKind::environment;
    fabric.light.file = file;
    edit(std::move(fabric));
  } else if (extension == ".png") {
    openPicture(file);
  } else if (isFabricFile(file) || isWeavingFile(file)) {
    pendingFile_ = file;
    leaveFor(Afterwards::open);
  } else {
    say("This file cannot be opened",
        file +
            ": expected a cloth (.loomlight, .json), a weaving file (.wif), a picture (.png), a mesh "
            "(.obj, .ply, .off) or an environment (.exr)");
  }
}

void Session::sayUnopened(const std::string& problem) {
  say("This file cannot be opened", problem);
}

void Session::save(const std::string& file) {
  files_.save(file, document_.fabric(), document_.state());
}

void Session::drawBusy(Ui& ui) {
  if (auto result = files_.take()) fileDone(std::move(*result));
  std::optional<std::string> text;
  if (const auto& busy = files_.busy()) {
    const char* does = files_.isReading() ? "Opening" : files_.canCancel() ? "Writing" : "Finishing";
    text = fmt::format("{} {}\xE2\x80\xA6", does, fs::path(busy->file).filename().string());
  }
  if (busyDialog_.draw(ui, text, files_.canCancel())) files_.cancel();
}

void Session::fileDone(FileDesk::Result result) {
  using Work = FileDesk::Work;
  const bool written = result.work == Work::save || result.work == Work::exportTo;
  if (!result.problem.empty() || result.cancelled) afterwards_ = Afterwards::nothing;
  if (result.cancelled) return;
  if (!result.problem.empty() && result.work == Work::usePreset)
    return say("This preset cannot be used", result.problem);
  if (!result.problem.empty() && !written) return sayUnopened(result.problem);
  if (!result.problem.empty())
    return say("The file could not be written", result.problem + "\n\nNothing is lost: the cloth is still here.");
  // Workers go on while a file is read: what they have edited since is asked about too.
  const bool editedSince = !written && result.state != document_.state() && document_.isDirty();
  switch (result.work) {
    case Work::open:
      if (editedSince) {
        pendingFile_ = result.file;
        return leaveFor(Afterwards::open);
      }
      if (isWeavingFile(result.file))
        return weavingOpened(std::move(*result.fabric), result.file, std::move(result.warnings));
      startOver(Document(std::move(*result.fabric), result.file));
      return remember(result.file);
    case Work::takeUp:
      if (editedSince) return leaveFor(Afterwards::takeUp);
      return takeUp(std::move(*result.fabric), result.file);
    case Work::usePreset:
      return dress(*result.fabric);
    case Work::save:
      document_.savedAs(result.file, result.state);
      remember(result.file);
      if (!document_.isDirty()) autosave_.forget();
      break;
    case Work::exportTo:
      lookNextIn(result.file);
      std::string text = "Written: " + result.file;
      for (const std::string& remark : result.remarks) text += "\n\n" + remark;
      say("Exported", text);
  }
  if (afterwards_ != Afterwards::nothing) leaveFor(afterwards_);
}

void Session::askForRecovery() {
  recoveryDue_ = false;
  const auto left = Autosave::leftBehind(stateFolder());
  if (!left) return;
  leftBehind_ = left->string();
  ask(Question::recover, "Unsaved work was found", aboutLeftWork(*left) + " Take it up again?",
      {"Later", "Throw away", "Take up"}, 2);
}

void Session::takeUp(Fabric fabric, const std::string& left) {
  startOver(Document(sampleFabric()));  // not into a file that was just opened
  edit(std::move(fabric));
  autosave_.takeOver(left);
}

fs::path Session::folderToLookIn() const {
  return settings_.folder.empty() ? homeFolder() : fs::path(settings_.folder);
}

fs::path Session::fileCalledAsCloth(const std::string& ending) const {
  return folderToLookIn() / (fileNameOf(document_.fabric()->name) + ending);
}

void Session::browse(FileTask task) {
  fileTask_ = task;
  previews_.forget();  // files change between two looks at them
  const fs::path folder = folderToLookIn();
  std::vector<FileBrowser::Place> places = {{"Home", homeFolder()}, {"Presets", presetFolder()}, {"Computer", "/"}};
  if (const auto samples = sampleFolder()) places.push_back({"Samples", *samples});
  using Purpose = FileBrowser::Purpose;
  switch (task) {
    case FileTask::open:
      browser_.show(Purpose::open, "Open a cloth", {".loomlight", ".json", ".wif", ".png"}, folder, places);
      break;
    case FileTask::saveAs: {
      const fs::path file = document_.file().empty() ? fileCalledAsCloth(".loomlight") : fs::path(document_.file());
      browser_.show(Purpose::save, "Save the cloth", {".loomlight", ".json"}, file, places);
      break;
    }
    case FileTask::mesh:
      browser_.show(Purpose::open, "Choose a mesh", {".obj", ".ply", ".off"}, folder, places);
      break;
    case FileTask::environment:
      browser_.show(Purpose::open, "Choose a surrounding", {".exr"}, folder, places);
      break;
    case FileTask::snapshot:
      browser_.show(Purpose::save, "Where the snapshot goes", {".png", ".exr"}, snapshotDialog_.file(), places);
      break;
    case FileTask::picture:
      browser_.show(Purpose::open, "Choose a picture", {".png"}, folder, places);
      break;
    case FileTask::exportWif:
      browser_.show(Purpose::save, "Export as weaving file", {".wif"}, fileCalledAsCloth(".wif"), places);
      break;
    case FileTask::exportDraft:
      browser_.show(Purpose::save, "Export the draft for print", {".pdf", ".png"}, fileCalledAsCloth(".pdf"), places);
      break;
    case FileTask::exportTile:
      browser_.show(Purpose::save, "Where the tile goes", {".json"}, tileDialog_.file(), places);
      break;
    case FileTask::exportBitmap:
      browser_.show(Purpose::save, "Export the weave", {".png"}, fileCalledAsCloth(".png"), places);
      break;
    case FileTask::none:
      break;
  }
}

void Session::fileChosen(const std::string& file) {
  const FileTask task = std::exchange(fileTask_, FileTask::none);
  switch (task) {
    case FileTask::open:
    case FileTask::mesh:
    case FileTask::environment:
    case FileTask::picture:
      openFile(file);
      break;
    case FileTask::saveAs:
      save(file);
      break;
    case FileTask::snapshot:
      snapshotDialog_.setFile(file);
      snapshot_.forget();
      break;
    case FileTask::exportTile:
      tileDialog_.setFile(file);
      tile_.forget();
      break;
    case FileTask::exportWif:
    case FileTask::exportBitmap:
    case FileTask::exportDraft:
      exportTo(task, file);
      break;
    case FileTask::none:
      break;
  }
}

}  // namespace loomlight
