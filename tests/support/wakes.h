#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <utility>

namespace loomlight {

/// What workers call when there is something to take, and a test waits for. A wake that comes before anybody waits is
/// not lost.
class Wakes {
 public:
  std::function<void()> callback() {
    return [this] {
      const std::lock_guard lock(mutex_);
      woken_ = true;
      came_.notify_all();
    };
  }
  /// Until the next wake, or for so long. False when none came.
  bool wait(std::chrono::duration<double> atMost) {
    std::unique_lock lock(mutex_);
    came_.wait_for(lock, atMost, [this] { return woken_; });
    return std::exchange(woken_, false);
  }
  /// Until it is so, looking again after each wake. False when it has not come about after minutes: only what hangs
  /// takes so long.
  template <class Condition>
  bool until(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + kHangs;
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      wait(kHangs);
    }
    return true;
  }
  static constexpr std::chrono::seconds kHangs{900};

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  bool woken_ = false;
};

}  // namespace loomlight
