#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "render/scene/embree.h"

namespace loomlight {

/// An Embree device, which counts what it has allocated. Release what was made with it first.
class EmbreeDevice {
 public:
  /// Throws std::runtime_error where Embree does not start.
  EmbreeDevice();
  ~EmbreeDevice() { rtcReleaseDevice(handle_); }
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  operator RTCDevice() const { return handle_; }
  /// Builds a scene of this device on up to `threads` threads; 0: all. What has gone wrong is for rtcGetDeviceError.
  void commit(RTCScene scene, int threads) const;
  size_t bytes() const { return static_cast<size_t>(bytes_.load()); }

 private:
  std::atomic<int64_t> bytes_{0};
  RTCDevice handle_;
};

}  // namespace loomlight
