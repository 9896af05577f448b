#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/services/file_preview_service.h"
#include "app/editor/services/file_service.h"
#include "ui/dialogs/busy_dialog.h"
#include "ui/dialogs/file_browser.h"

namespace loomlight {

/// What a file is chosen for.
enum class FileTask {
  none,
  open,
  saveAs,
  mesh,
  environment,
  snapshot,
  exportWif,
  exportBitmap,
  exportDraft,
  exportTile,
  handover,
  sheet,
  colourwaySheet,
  picture,
  profile
};

/// The browser of files, the reading and writing of them, and files that were dropped on the window.
class FileController {
 public:
  FileController(DisplayDriver& driver, const std::function<void()>& wake) : service_(wake), previews_(driver, wake) {}

  /// Opens the browser: in a folder, or for a task that writes on a file.
  void browse(FileTask task, const std::filesystem::path& start);
  bool isBrowsing() const { return browser_.isOpen(); }
  struct Chosen {
    FileTask task = FileTask::none;
    std::string file;
  };
  /// Once.
  std::optional<Chosen> drawBrowser(Ui& ui);
  /// Says what is being read or written. What has been, once.
  std::optional<FileService::Result> drawBusy(Ui& ui);

  FileService& service() { return service_; }
  const FileService& service() const { return service_; }

  struct Dropped {
    std::string file;
    std::optional<int> yarn;  ///< of the cloth, that it was dropped on
  };
  void drop(const std::vector<std::string>& files) { arriving_.insert(arriving_.end(), files.begin(), files.end()); }
  /// In the frame after it: what has been dropped lies on this yarn.
  void placeDropped(const std::optional<int>& yarn);
  /// The next of those dropped.
  std::optional<Dropped> takeDropped();

 private:
  FileService service_;
  FileBrowser browser_;
  FilePreviewService previews_;
  BusyDialog busy_;
  FileTask task_ = FileTask::none;
  std::vector<std::string> arriving_;  ///< files that were dropped since the last frame
  std::deque<Dropped> dropped_;        ///< that wait until no dialog is open
};

}  // namespace loomlight
