#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace loomlight {

/// Brings on threads of its own what may never come, as from a disk that has gone. Only what was asked for last counts:
/// what was begun before goes on unseen, and of what waits none but the last is begun. One that hangs holds up neither
/// the next, for a few go on side by side, nor the end: the destructor waits a moment, and leaves behind what hangs
/// still. What is asked for therefore owns all that it uses.
template <class T>
class Fetcher {
 public:
  using StillWanted = std::function<bool()>;
  /// Must not throw.
  using Fetch = std::function<T(const StillWanted&)>;

  /// `wake` is called from the threads when there is something to take(), and never after the destructor has begun.
  explicit Fetcher(std::function<void()> wake) : shared_(std::make_shared<Shared>()) {
    shared_->wake = std::move(wake);
  }
  Fetcher(const Fetcher&) = delete;
  Fetcher& operator=(const Fetcher&) = delete;
  ~Fetcher() {
    forget();
    // What does not hang has ended before the program's own end begins.
    constexpr std::chrono::seconds kMoment{1};
    std::unique_lock lock(shared_->mutex);
    shared_->ended.wait_for(lock, kMoment, [this] { return shared_->running == 0; });
  }

  /// Never waits.
  void ask(Fetch fetch) {
    constexpr int kMostAtOnce = 3;
    forget();
    const std::lock_guard lock(shared_->mutex);
    shared_->waiting = std::move(fetch);
    if (shared_->running == kMostAtOnce) return;
    std::thread([shared = shared_] { work(*shared); }).detach();
    ++shared_->running;
  }

  /// Nothing comes of what was asked for.
  void forget() {
    std::optional<T> unseen;  // it may be large: it dies outside the lock
    const std::lock_guard lock(shared_->mutex);
    ++shared_->wanted;
    shared_->waiting = nullptr;
    shared_->brought.swap(unseen);
  }

  /// What was asked for last, once it is there; once.
  std::optional<T> take() {
    const std::lock_guard lock(shared_->mutex);
    return std::exchange(shared_->brought, std::nullopt);
  }

 private:
  /// Outlives the fetcher for as long as a thread does.
  struct Shared {
    std::mutex mutex;
    std::condition_variable ended;
    std::function<void()> wake;
    Fetch waiting;
    std::optional<T> brought;
    uint64_t wanted = 0;  ///< counts what was asked for and forgotten
    int running = 0;      ///< threads
  };

  static void work(Shared& shared) {
    for (;;) {
      Fetch fetch;
      uint64_t number = 0;
      {
        const std::lock_guard lock(shared.mutex);
        fetch = std::exchange(shared.waiting, nullptr);
        number = shared.wanted;
        if (!fetch) {
          --shared.running;
          shared.ended.notify_all();
          return;
        }
      }
      std::optional<T> brought = fetch([&shared, number] {
        const std::lock_guard lock(shared.mutex);
        return shared.wanted == number;
      });
      const std::lock_guard lock(shared.mutex);
      if (shared.wanted != number) continue;
      shared.brought.swap(brought);
      shared.wake();
    }
  }

  std::shared_ptr<Shared> shared_;
};

}  // namespace loomlight
