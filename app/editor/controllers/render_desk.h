#pragma once

#include <memory>
#include <optional>

#include "app/export/file_job.h"
#include "ui/dialogs/render_job.h"

namespace loomlight {

/// A picture or a tile on its way to a file, and what its dialog says of it. In the thread of the window; no call
/// waits.
class RenderDesk {
 public:
  void start(FileJob::Work work);
  bool isRunning() const { return job_ != nullptr; }
  void cancel();
  /// Looks how far it is. Once it is over, whether it was written.
  std::optional<bool> follow();
  const RenderJob& progress() const { return progress_; }
  /// What is said of the last one, when its dialog opens anew, or asks for another.
  void forget();

 private:
  std::unique_ptr<FileJob> job_;
  RenderJob progress_;
};

}  // namespace loomlight
