#pragma once

#include <chrono>
#include <ctime>

namespace loomlight {

/// Wall time that has gone by since then, s.
inline double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Wall time, lap by lap.
class Stopwatch {
 public:
  /// Seconds since it was made, or since the last lap.
  double lap() {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - began_).count();
    began_ = now;
    return seconds;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point began_ = Clock::now();
};

/// Processor time of all threads, lap by lap: what other programs do on the machine hardly moves it.
class CpuStopwatch {
 public:
  double lap() {
    const std::clock_t now = std::clock();
    const double seconds = static_cast<double>(now - began_) / CLOCKS_PER_SEC;
    began_ = now;
    return seconds;
  }

 private:
  std::clock_t began_ = std::clock();
};

}  // namespace loomlight
