#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/editor/picture_texture.h"
#include "app/workers/mailbox.h"
#include "app/workers/task_queue.h"
#include "ui/file_preview.h"

namespace loomlight {

/// Looks into files before they are opened, on a thread of its own. What was asked for last is what counts: a file that
/// is being read is read to its end, and of those that wait none but the last.
class FilePreviewDesk {
 public:
  /// `wake` is called from the thread when there is something to see.
  explicit FilePreviewDesk(std::function<void()> wake);
  ~FilePreviewDesk() { forget(); }

  /// What is known of the file by now; nothing of an empty name. The last files that were looked into are
  /// remembered until forget(), as they were then. In the thread of the window.
  FilePreview of(const std::string& file);
  void forget();

 private:
  struct Look {
    Pixels8 picture;  ///< three channels; nothing where there is none
    std::vector<std::string> lines;
  };
  struct Known {
    std::unique_ptr<PictureTexture> texture;
    FilePreview preview;
  };
  static Look lookInto(const std::string& file);
  void take();

  std::function<void()> wake_;
  std::map<std::string, Known> known_;
  std::string asked_;
  std::atomic<uint64_t> wanted_ = 0;
  Mailbox<std::pair<std::string, Look>> looks_;
  TaskQueue tasks_;  // last: it ends before what its tasks use is gone
};

}  // namespace loomlight
