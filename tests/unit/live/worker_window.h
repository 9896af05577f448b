#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

#include "tests/support/wakes.h"

namespace loomlight::test {

/// Waits for what workers do, as the window does: woken, then looking.
class WorkerWindow {
 public:
  std::function<void()> waker() {
    return [this] {
      std::lock_guard lock(mutex_);
      ++wakes_;
      woken_.notify_all();
    };
  }
  /// False when it has not come true by then: only what hangs takes so long.
  template <class Condition>
  bool waitFor(Condition&& condition) {
    const auto deadline = std::chrono::steady_clock::now() + Wakes::kHangs;
    std::unique_lock lock(mutex_);
    for (;;) {
      const int seen = wakes_;
      lock.unlock();
      if (condition()) return true;
      lock.lock();
      if (!woken_.wait_until(lock, deadline, [&] { return wakes_ != seen; })) return false;
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable woken_;
  int wakes_ = 0;
};

}  // namespace loomlight::test
