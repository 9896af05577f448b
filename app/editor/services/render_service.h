#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/live/worker.h"
#include "core/base/task.h"
#include "ui/dialogs/render_job.h"

namespace loomlight {

/// A picture or a tile on its way to a file, and what its dialog says of it. In the thread of the window; no call
/// waits, but the destructor, which cancels, for as long as the work takes to notice.
class RenderService {
 public:
  /// Returns what was written, in words; nothing where it was stopped before it wrote any. May throw.
  using Work = std::function<std::optional<std::string>(const Task&)>;
  RenderService();

  void start(Work work);
  bool isRunning() const { return progress_.running; }
  void cancel() { worker_.cancel(); }
  /// Looks how far it is. Once it is over, whether it was written.
  std::optional<bool> follow();
  const RenderJob& progress() const { return progress_; }
  /// What is said of the last one, when its dialog opens anew, or asks for another.
  void forget();

 private:
  struct Told {
    RenderJob progress;
    bool written = false;
  };
  RenderJob progress_;
  Worker<Work, Told> worker_;
};

}  // namespace loomlight
