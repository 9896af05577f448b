#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace loomlight {

/// Latest-wins hand-over of a value from one thread to another: depth one, no backlog. post() never waits for the
/// receiver.
template <class T>
class Mailbox {
 public:
  void post(T value) {
    std::optional<T> other(std::move(value));  // then what nobody took: a whole scene may die of it, outside the lock
    {
      std::lock_guard lock(mutex_);
      value_.swap(other);
    }
    arrived_.notify_one();
  }

  /// What has arrived since the last call, if anything.
  std::optional<T> take() {
    std::lock_guard lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }

  /// Whether something has arrived that nobody has taken yet.
  bool waiting() const {
    std::lock_guard lock(mutex_);
    return value_.has_value();
  }

  /// Sleeps until something arrives; nullopt once stop is requested.
  std::optional<T> wait(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    arrived_.wait(lock, stop, [&] { return value_.has_value(); });
    if (stop.stop_requested()) return std::nullopt;
    return std::exchange(value_, std::nullopt);
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::optional<T> value_;
};

}  // namespace loomlight
