#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "render/scene/embree.h"

namespace loomlight {

/// An Embree device, which counts what it has allocated. Release what was made with it first.
class EmbreeDevice {
 public:
  /// For so many threads of Embree's builder; 0: all. Throws std::runtime_error where Embree does not start.
  explicit EmbreeDevice(int threads);
  ~EmbreeDevice() { rtcReleaseDevice(handle_); }
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  operator RTCDevice() const { return handle_; }
  size_t bytes() const { return static_cast<size_t>(bytes_.load()); }

 private:
  std::atomic<int64_t> bytes_{0};
  RTCDevice handle_;
};

}  // namespace loomlight
