#pragma once

#include <stop_token>
#include <thread>

#include "core/base/task.h"

namespace loomlight {

/// While one lives, Ctrl-C and a request to terminate ask for a stop, so that work can end in good order; a second one
/// ends the program at once. Make it before any other thread is started: threads inherit which signals they leave to
/// it. One at a time.
class Interrupt {
 public:
  static constexpr int kExitStatus = 130;  ///< of a program that was stopped: 128 + SIGINT, as shells have it

  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return source_.get_token(); }
  /// Work that it stops, on so many threads; 0: all.
  Task task(int threads) const;

 private:
  std::stop_source source_;
  std::thread listener_;
};

}  // namespace loomlight
