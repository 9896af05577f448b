#include "app/export/file_job.h"

#include <algorithm>
#include <exception>
#include <mutex>

#include "core/base/parallel.h"

namespace loomlight {

struct FileJob::Shared {
  mutable std::mutex mutex;
  State state;

  void run(std::stop_token stop, const Work& work) {
    Task task;
    task.stop = std::move(stop);
    task.threads = std::max(1, hardwareThreads() - 1);  // the window keeps its core
    task.progress = [this](double fraction) {
      std::lock_guard lock(mutex);
      state.progress = fraction;
    };
    State last;
    try {
      const std::optional<std::string> written = work(task);
      last.phase = written ? State::Phase::written : State::Phase::cancelled;
      last.outcome = written.value_or("Cancelled; nothing was written.");
    } catch (const std::exception& error) {
      last.phase = State::Phase::failed;
      last.outcome = error.what();
    }
    std::lock_guard lock(mutex);
    state = std::move(last);
  }
};

FileJob::FileJob(Work work) : shared_(std::make_shared<Shared>()) {
  thread_ = std::jthread(
      [shared = shared_, work = std::move(work)](std::stop_token stop) { shared->run(std::move(stop), work); });
}

FileJob::State FileJob::state() const {
  std::lock_guard lock(shared_->mutex);
  return shared_->state;
}

}  // namespace loomlight
