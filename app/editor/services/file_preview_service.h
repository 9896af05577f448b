#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/editor/display/display_driver.h"
#include "app/live/worker.h"
#include "ui/dialogs/file_preview.h"

namespace loomlight {

/// Looks into files before they are opened, but not in the thread of the window. What was asked for last is what
/// counts.
class FilePreviewService {
 public:
  /// `wake` is called from the thread when there is something to see.
  FilePreviewService(DisplayDriver& driver, std::function<void()> wake);

  /// What is known of the file by now; nothing of an empty name. The last files that were looked into are
  /// remembered until forget(), as they were then. In the thread of the window.
  FilePreview of(const std::string& file);
  void forget();

 private:
  struct Look {
    Pixels8 picture;  ///< three channels; nothing where there is none
    std::vector<std::string> lines;
    bool isComing = false;  ///< there is more to come
  };
  using Looks = Worker<std::string, std::pair<std::string, Look>>;
  struct Known {
    std::unique_ptr<PictureTexture> texture;
    FilePreview preview;
  };
  static Look lookInto(const std::string& file, const Looks::Job& job);
  void take();

  DisplayDriver& driver_;
  std::map<std::string, Known> known_;
  std::string asked_;
  Looks looks_;
};

}  // namespace loomlight
