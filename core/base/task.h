#pragma once

#include <functional>
#include <stop_token>

namespace loomlight {

/// What long work is given by its caller: a way to be stopped, a way to report how far it is, how many threads to use.
/// Work polls `stop` often (per path, per brick) and returns early, with nothing half-built, once it is requested.
struct Task {
  std::stop_token stop;
  std::function<void(double fraction)> progress;  ///< may be empty; called from any thread, fraction in [0, 1]
  int threads = 0;                                ///< 0: all hardware threads

  bool stopped() const { return stop.stop_requested(); }
  void report(double fraction) const {
    if (progress) progress(fraction);
  }
};

/// Not to be stopped, and on the caller's thread alone.
inline Task oneThread() {
  Task task;
  task.threads = 1;
  return task;
}

}  // namespace loomlight
