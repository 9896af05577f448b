#pragma once

#include <ctime>

namespace loomlight {

/// Processor time of the calling thread, s: what it did itself, however busy the machine is.
inline double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace loomlight
