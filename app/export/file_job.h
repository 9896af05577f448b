#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "core/base/task.h"

namespace loomlight {

/// Work that ends in files, on a thread of its own; one core stays with the window. The destructor cancels and waits
/// for as long as the work takes to notice.
class FileJob {
 public:
  /// Returns what was written, in words; nothing where it was stopped before it wrote any. May throw.
  using Work = std::function<std::optional<std::string>(const Task&)>;
  explicit FileJob(Work work);
  void cancel() { thread_.request_stop(); }

  struct State {
    enum class Phase { running, written, cancelled, failed };
    Phase phase = Phase::running;
    double progress = 0;  ///< 0..1
    std::string outcome;  ///< once it is over: what was written, or why not all was
  };
  State state() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

}  // namespace loomlight
