#include "app/live/task_queue.h"

#include <utility>

namespace loomlight {

TaskQueue::TaskQueue() {
  thread_ = std::jthread([this](std::stop_token stop) { loop(stop); });
}

void TaskQueue::post(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  arrived_.notify_one();
}

void TaskQueue::loop(std::stop_token stop) {
  for (;;) {
    std::function<void()> task;
    {
      std::unique_lock lock(mutex_);
      arrived_.wait(lock, stop, [this] { return !tasks_.empty(); });
      if (tasks_.empty()) return;  // only once it is to stop
      task = std::move(tasks_.front());
      tasks_.pop_front();
    }
    task();
  }
}

}  // namespace loomlight
