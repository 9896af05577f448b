#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace loomlight {

/// Does things one after the other on a thread of its own, in the order in which they were asked for. The destructor
/// waits for all of them: nothing that was to be written is lost.
class TaskQueue {
 public:
  TaskQueue();

  /// Never waits. The task must not throw.
  void post(std::function<void()> task);

 private:
  void loop(std::stop_token stop);

  std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::deque<std::function<void()>> tasks_;
  std::jthread thread_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
